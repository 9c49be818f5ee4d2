/// The binary data of a glTF file: its buffers, with the positions and vertex indices in them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/base/math.h"

namespace demos {

using GltfJson = nlohmann::json;

/// A whole number of at most 2^31 - 1; `otherwise` if it is missing. Throws MeshFileError, like
/// all functions here.
std::size_t wholeOf(const GltfJson& object, const char* key, std::optional<std::size_t> otherwise);

/// The number-th object of the file's list `key`.
const GltfJson& itemOf(const GltfJson& file, const char* key, std::size_t number);

class GltfBuffers {
public:
    /// `chunk`: the binary chunk of a .glb, which is its first buffer.
    GltfBuffers(const GltfJson& file, std::filesystem::path folder,
                std::optional<std::string> chunk);

    /// The points of an accessor: three floats each, all finite.
    std::vector<engine::Vec3> positions(std::size_t accessor);
    /// The numbers of an accessor: unsigned, of 8, 16 or 32 bits.
    std::vector<std::uint32_t> numbers(std::size_t accessor);
    /// The files read so far.
    const std::vector<std::string>& paths() const { return paths_; }

private:
    struct Elements {
        const unsigned char* first;
        std::size_t count, stride;  // bytes
        std::size_t componentType;
    };
    Elements elementsOf(std::size_t accessor, const char* type, bool floats);
    const std::string& buffer(std::size_t number);
    std::string load(const GltfJson& buffer, std::size_t number);
    void keep(std::size_t number, std::string bytes);

    const GltfJson& file_;
    std::filesystem::path folder_;
    std::optional<std::string> chunk_;
    std::vector<std::optional<std::string>> loaded_;
    std::size_t bytes_ = 0;  // of all loaded buffers
    std::vector<std::string> paths_;
};

}  // namespace demos
