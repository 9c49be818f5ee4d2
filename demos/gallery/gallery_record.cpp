#include "demos/gallery/gallery_record.h"

#include <nlohmann/json.hpp>

#include "demos/film/progress.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"
#include "demos/text/text_hash.h"
#include "demos/text/version.h"
#include "render/encode/file.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

std::uint64_t numberOf(const Json& json, const char* key) {
    return std::stoull(json.at(key).get<std::string>(), nullptr, 16);
}

}  // namespace

GalleryRecord::GalleryRecord(std::filesystem::path folder) : folder_(std::move(folder)) {
    try {
        const std::vector<std::uint8_t> bytes =
            contentOf(folder_ / "gallery.json", kGalleryJson.bytes);
        checkJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, kGalleryJson);
        const Json json = Json::parse(bytes.begin(), bytes.end());
        std::map<std::string, GalleryEntry> entries;
        for (const auto& [name, entry] : json.at("scenes").items())
            entries[name] = {numberOf(entry, "fingerprint"), numberOf(entry, "poster"),
                             numberOf(entry, "film"), numberOf(entry, "replay"),
                             entry.value("incident", "")};
        sheet = numberOf(json, "sheet");
        entries_ = std::move(entries);
        found_ = true;
    } catch (const std::exception&) {  // then no file is ours
    }
}

std::filesystem::path GalleryRecord::posterFile(const std::string& name) const {
    return folder_ / (name + ".png");
}

std::filesystem::path GalleryRecord::filmFile(const std::string& name) const {
    return folder_ / (name + ".mp4");
}

std::filesystem::path GalleryRecord::replayFile(const std::string& name) const {
    return folder_ / (name + ".html");
}

bool GalleryRecord::isOutdated(const GalleryCard& card) const {
    const auto entry = entries_.find(card.name);
    return entry != entries_.end() && entry->second.poster != 0 &&
           entry->second.fingerprint != card.fingerprint;
}

bool GalleryRecord::has(const GalleryCard& card, const GalleryKinds& made) const {
    const auto found = entries_.find(card.name);
    if (found == entries_.end() || found->second.fingerprint != card.fingerprint) return false;
    const GalleryEntry& entry = found->second;
    const auto stands = [](std::uint64_t hash, const std::filesystem::path& file) {
        return hash != 0 && hashOfFile(file) == hash;
    };
    return stands(entry.poster, posterFile(card.name)) &&
           (!made.films || stands(entry.film, filmFile(card.name))) &&
           (!made.replays || stands(entry.replay, replayFile(card.name)));
}

std::uint64_t GalleryRecord::posterOf(const std::string& name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? 0 : found->second.poster;
}

std::string GalleryRecord::incidentOf(const std::string& name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? "" : found->second.incident;
}

void GalleryRecord::write() const {
    Json json{{"impulse", kVersion}, {"command", command}, {"sheet", hexText(sheet)}};
    json["scenes"] = Json::object();
    for (const auto& [name, entry] : entries_) {
        json["scenes"][name] = {{"fingerprint", hexText(entry.fingerprint)},
                                {"poster", hexText(entry.poster)},
                                {"film", hexText(entry.film)},
                                {"replay", hexText(entry.replay)}};
        if (!entry.incident.empty()) json["scenes"][name]["incident"] = entry.incident;
    }
    render::writeFileAtomically(folder_ / "gallery.json",
                                json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace demos
