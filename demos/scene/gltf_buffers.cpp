// Every offset, length and count is checked against the actual data before it is used.
#include "demos/scene/gltf_buffers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>
#include <utility>

#include "demos/scene/mesh_file.h"
#include "demos/text/base64.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

constexpr std::size_t kLongestUri = 1000;  // bytes
constexpr std::size_t kUnsigned8 = 5121, kUnsigned16 = 5123, kUnsigned32 = 5125, kFloat = 5126;

std::size_t sizeOf(std::size_t componentType) {
    return componentType == kUnsigned8 ? 1 : componentType == kUnsigned16 ? 2 : 4;
}

/// The file name of a URI such as "my%20mesh.bin".
std::string unescaped(const std::string& uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const std::size_t high = uri[i] == '%' && i + 2 < uri.size() ? 1 : 0;
        constexpr std::string_view kHex = "0123456789abcdef0123456789ABCDEF";
        const std::size_t a = high ? kHex.find(uri[i + 1]) : kHex.npos;
        const std::size_t b = high ? kHex.find(uri[i + 2]) : kHex.npos;
        const bool escaped = a != kHex.npos && b != kHex.npos;
        name += escaped ? static_cast<char>(a % 16 * 16 + b % 16) : uri[i];
        if (escaped) i += 2;
    }
    return name;
}

/// glTF files come from elsewhere: they read no files but those that came with them.
void checkBufferName(const std::string& name) {
    const std::filesystem::path path(name);
    if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
        throw MeshFileError("is outside the glTF file's folder; it should be in it, or below it");
    if (name.empty() || name.find('\0') != std::string::npos || name.size() > kLongestUri)
        throw MeshFileError("is not a file name of 1 to 1000 bytes");
}

/// Also where a link leads.
void checkBufferPlace(const std::filesystem::path& folder, const std::string& name) {
    std::error_code ignored;
    const auto real = [&](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
    };
    const std::filesystem::path around = real(folder.empty() ? "." : folder), file = real(folder / name);
    if (std::mismatch(around.begin(), around.end(), file.begin(), file.end()).first != around.end())
        throw MeshFileError("is a link out of the glTF file's folder; it should be a file in it, or below it");
}

std::uint32_t littleEndian(const unsigned char* bytes, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
    return value;
}

std::string numbered(const char* what, std::size_t number) {
    return std::string(what) + " " + std::to_string(number);
}

}  // namespace

std::size_t wholeOf(const GltfJson& object, const char* key, std::optional<std::size_t> otherwise) {
    constexpr std::uint64_t kMost = 0x7fffffff;
    const auto found = object.find(key);
    if (found == object.end()) {
        if (otherwise) return *otherwise;
        throw MeshFileError(std::string("lacks a '") + key + "'; it should be a whole number");
    }
    if (found->is_number_unsigned() && found->get<std::uint64_t>() <= kMost)
        return found->get<std::size_t>();
    throw MeshFileError(std::string("a '") + key +
                        "' should be a whole number from 0 to 2147483647");
}

const GltfJson& itemOf(const GltfJson& file, const char* key, std::size_t number) {
    const auto list = file.find(key);
    const std::size_t count = list != file.end() && list->is_array() ? list->size() : 0;
    if (number < count && (*list)[number].is_object()) return (*list)[number];
    throw MeshFileError(std::string("there is no ") + numbered(key, number) + "; it has " +
                        std::to_string(count));
}

GltfBuffers::GltfBuffers(const GltfJson& file, std::filesystem::path folder,
                         std::optional<std::string> chunk)
    : file_(file), folder_(std::move(folder)), chunk_(std::move(chunk)) {
    const auto list = file_.find("buffers");
    if (list != file_.end() && list->is_array()) loaded_.resize(list->size());
}

std::string GltfBuffers::load(const GltfJson& buffer, std::size_t number) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
        if (number == 0 && chunk_) return *chunk_;
        throw MeshFileError(numbered("buffer", number) + " has no uri and no binary chunk");
    }
    if (!uri->is_string()) throw MeshFileError(numbered("buffer", number) + ": uri is not a text");
    const std::string& text = uri->get_ref<const std::string&>();
    if (!text.starts_with("data:")) {
        const std::string name = unescaped(text);
        try {
            checkBufferName(name);
            checkBufferPlace(folder_, name);
            paths_.push_back((folder_ / name).string());
            return readWholeFile(folder_ / name);
        } catch (const MeshFileError& error) {
            throw MeshFileError("its buffer " + printable(shown(name)) + ": " + error.what());
        }
    }
    constexpr std::string_view kBase64 = ";base64,";
    const std::size_t at = text.find(kBase64);
    const auto bytes = at == std::string::npos
                           ? std::nullopt
                           : fromBase64(std::string_view(text).substr(at + kBase64.size()));
    if (!bytes) throw MeshFileError(numbered("buffer", number) + ": a data uri should be base64");
    return *bytes;
}

/// Limits the sum: a small file may name a large one a thousand times.
void GltfBuffers::keep(std::size_t number, std::string bytes) {
    bytes_ += bytes.size();
    if (bytes_ > kMostMeshBytes)
        throw MeshFileError("its buffers have more than 64 MiB together; simplify the mesh");
    loaded_[number] = std::move(bytes);
}

const std::string& GltfBuffers::buffer(std::size_t number) {
    const GltfJson& json = itemOf(file_, "buffers", number);
    std::optional<std::string>& bytes = loaded_[number];
    if (!bytes) keep(number, load(json, number));
    const std::size_t length = wholeOf(json, "byteLength", std::nullopt);
    if (bytes->size() < length)
        throw MeshFileError(numbered("buffer", number) + " has " + std::to_string(bytes->size()) +
                            " bytes; its byteLength is " + std::to_string(length));
    return *bytes;
}

GltfBuffers::Elements GltfBuffers::elementsOf(std::size_t accessor, const char* type, bool floats) {
    const GltfJson& json = itemOf(file_, "accessors", accessor);
    const std::string name = numbered("accessor", accessor);
    if (json.contains("sparse"))
        throw MeshFileError(name + " is sparse, which is not supported; it should be written out");
    const auto given = json.find("type");
    const std::size_t component = wholeOf(json, "componentType", std::nullopt);
    const bool known =
        floats ? component == kFloat
               : component == kUnsigned8 || component == kUnsigned16 || component == kUnsigned32;
    if (given == json.end() || *given != type || !known)
        throw MeshFileError(
            name + " should be " + type + " of " +
            (floats ? "floats (5126)" : "unsigned bytes, shorts or ints (5121, 5123, 5125)"));
    const std::size_t count = wholeOf(json, "count", std::nullopt);
    const GltfJson& view = itemOf(file_, "bufferViews", wholeOf(json, "bufferView", std::nullopt));
    const std::string& bytes = buffer(wholeOf(view, "buffer", std::nullopt));
    const std::size_t size = sizeOf(component) * (floats ? 3 : 1);
    const std::size_t stride = wholeOf(view, "byteStride", size);
    if (stride < size)
        throw MeshFileError(name + " has a byteStride of " + std::to_string(stride) +
                            "; byteStride should be " + std::to_string(size) + " or more");
    const std::size_t start = wholeOf(view, "byteOffset", 0);
    const std::size_t length = wholeOf(view, "byteLength", std::nullopt);
    const std::size_t offset = wholeOf(json, "byteOffset", 0);
    const std::size_t end = count == 0 ? 0 : offset + (count - 1) * stride + size;
    if (start + length > bytes.size() || end > length)
        throw MeshFileError(name + " reaches beyond the end of its buffer");
    const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
    return {count == 0 ? first : first + start + offset, count, stride, component};
}

std::vector<engine::Vec3> GltfBuffers::positions(std::size_t accessor) {
    const Elements elements = elementsOf(accessor, "VEC3", true);
    std::vector<engine::Vec3> points(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t bits =
                littleEndian(elements.first + i * elements.stride + 4 * k, 4);
            points[i][static_cast<int>(k)] = static_cast<double>(std::bit_cast<float>(bits));
        }
    for (const engine::Vec3& point : points)
        if (!point.allFinite())
            throw MeshFileError(numbered("accessor", accessor) +
                                " holds a number that is not finite");
    return points;
}

std::vector<std::uint32_t> GltfBuffers::numbers(std::size_t accessor) {
    const Elements elements = elementsOf(accessor, "SCALAR", false);
    std::vector<std::uint32_t> numbers(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i)
        numbers[i] =
            littleEndian(elements.first + i * elements.stride, sizeOf(elements.componentType));
    return numbers;
}

}  // namespace demos
