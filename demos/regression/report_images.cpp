#include "demos/regression/report_images.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "demos/text/base64.h"
#include "demos/text/escaped_path.h"
#include "demos/text/file_content.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kPrefix = "data:image/png;base64,";
constexpr long kEntry = 64;  // bytes around a picture's address, and of its two indices in the JSON

std::string linkTo(const fs::path& file, const fs::path& folder) {
    std::error_code error;
    const fs::path relative = fs::proximate(file, folder.empty() ? "." : folder, error);
    return escapedPath((error ? file : relative).generic_string());
}

class Images {
public:
    Images(fs::path folder, long bytes) : folder_(std::move(folder)), left_(bytes) {}

    /// The index of a file's picture in all(); adds it on the first call.
    int placeOf(const std::string& file) {
        if (file.empty()) return -1;
        const auto [found, isNew] = places_.emplace(file, -1);
        if (isNew) found->second = add(file);
        return found->second;
    }
    const Json& all() const { return all_; }

private:
    int add(const std::string& file) {
        std::error_code error;
        if (!fs::is_regular_file(fs::symlink_status(file, error))) return -1;
        const auto size = static_cast<long>(fs::file_size(file, error));
        if (error) return -1;
        const bool fits = size / 3 * 4 + 4 + static_cast<long>(kPrefix.size()) + kEntry <= left_;
        const std::string source = fits ? embedded(file) : linkTo(file, folder_);
        if (source.empty()) return -1;
        left_ -= static_cast<long>(source.size()) + kEntry;
        all_.push_back({{"src", source}, {"linked", !fits}});
        return static_cast<int>(all_.size()) - 1;
    }
    static std::string embedded(const std::string& file) {
        const std::vector<std::uint8_t> bytes = contentOf(file);
        return bytes.empty() ? "" : std::string(kPrefix) + toBase64(bytes);
    }

    fs::path folder_;
    long left_;  // bytes
    std::map<std::string, int> places_;
    Json all_ = Json::array();
};

/// Two identical pictures are stored once.
void addPicture(Json& json, const PictureVerdict& picture, Images& images) {
    const int baseline = images.placeOf(picture.baseline);
    const bool once = picture.kind == PictureVerdict::Kind::same && baseline >= 0;
    json["baseline_image"] = baseline;
    json["actual_image"] = once ? baseline : images.placeOf(picture.actual);
}

/// A review needs these pictures; the others only show what a scene should look like.
bool isFirst(const SceneVerdict& scene, const PictureVerdict& picture) {
    return scene.state != SceneVerdict::State::passed || picture.kind != PictureVerdict::Kind::same;
}

}  // namespace

void addImages(Json& page, const TestVerdict& verdict, const fs::path& folder, long bytes) {
    Images images(folder, bytes);
    for (const bool first : {true, false})
        for (std::size_t i = 0; i < verdict.scenes.size(); ++i)
            for (std::size_t k = 0; k < verdict.scenes[i].pictures.size(); ++k) {
                const PictureVerdict& picture = verdict.scenes[i].pictures[k];
                if (isFirst(verdict.scenes[i], picture) == first)
                    addPicture(page["scenes"][i]["pictures"][k], picture, images);
            }
    page["images"] = images.all();
}

}  // namespace demos
