#include "demos/slides/sections_json.h"

#include <nlohmann/json.hpp>

#include "demos/slides/slide_media.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMadeBy = "impulse slides";

Json sectionJson(const MadeSlide& made) {
    const std::vector<const MadePicture*> pictures = picturesOf(made);
    Json entry{{"id", made.slide.id}, {"title", made.slide.title}};
    if (hasFilm(made)) {
        entry["file"] = filmName(made);
        entry["frames"] = made.film->frames;
        entry["fps"] = made.film->fps;
    }
    if (!pictures.empty()) entry["poster"] = pictureName(made, 0);
    for (std::size_t i = 1; i < pictures.size(); ++i)
        entry["pictures"].push_back(pictureName(made, i));
    entry["loop"] = made.slide.loop;
    entry["pause"] = made.slide.pause;
    entry["notes"] = made.slide.notes;
    if (!made.command.empty()) entry["command"] = made.command;
    return entry;
}

/// Accepts only names in these two folders: a link in a deeper path may lead elsewhere.
bool isOurPlace(const std::filesystem::path& name) {
    const std::string file = name.filename().string();
    return !file.empty() && file != "." && file != ".." &&
           (name == file || name == std::filesystem::path("media") / file);
}

}  // namespace

std::string sectionsJson(const MadeDeck& made, const std::vector<std::filesystem::path>& files) {
    Json entry{{"made_by", kMadeBy},
              {"title", made.deck.title},
              {"resolution", {made.deck.size.width, made.deck.size.height}},
              {"files", Json::array()},
              {"slides", Json::array()}};
    for (const std::filesystem::path& file : files) entry["files"].push_back(file.generic_string());
    for (const MadeSlide& slide : made.slides) entry["slides"].push_back(sectionJson(slide));
    return entry.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::filesystem::path> listedFiles(const std::filesystem::path& folder) {
    const std::vector<std::uint8_t> bytes =
        contentOf(folder / "sections.json", kSectionsJson.bytes);
    const std::string text(bytes.begin(), bytes.end());
    if (!jsonTrouble(text, kSectionsJson).empty()) return {};
    const Json entry = Json::parse(text, nullptr, false);
    if (!entry.is_object() || entry.value("made_by", Json()) != kMadeBy) return {};
    std::vector<std::filesystem::path> files;
    for (const Json& name : entry.value("files", Json::array())) {
        if (!name.is_string()) continue;
        const std::filesystem::path file = name.get<std::string>();
        if (isOurPlace(file)) files.push_back(file);
    }
    return files;
}

}  // namespace demos
