#include "demos/regression/pass_cache.h"

#include <nlohmann/json.hpp>

#include "demos/text/file_content.h"
#include "demos/text/hex_text.h"
#include "demos/text/json_limits.h"
#include "render/encode/file.h"

namespace demos {

using SortedJson = nlohmann::json;

PassCache::PassCache(std::filesystem::path file) : file_(std::move(file)) {
    const std::vector<std::uint8_t> bytes = contentOf(file_, kPassedJson.bytes);
    const std::string text(bytes.begin(), bytes.end());
    if (!jsonTrouble(text, kPassedJson).empty()) return;
    const SortedJson json = SortedJson::parse(text, nullptr, false);
    if (!json.is_object()) return;
    for (const auto& [scene, value] : json.items()) {
        if (!value.is_string()) continue;
        if (const auto fingerprint = fromHex(value.get<std::string>()))
            passed_[scene] = *fingerprint;
    }
}

bool PassCache::has(const std::string& scene, std::uint64_t fingerprint) const {
    const auto found = passed_.find(scene);
    return found != passed_.end() && found->second == fingerprint;
}

void PassCache::add(const std::string& scene, std::uint64_t fingerprint) {
    passed_[scene] = fingerprint;
}

void PassCache::remove(const std::string& scene) { passed_.erase(scene); }

void PassCache::write() const {
    SortedJson json = SortedJson::object();
    for (const auto& [scene, fingerprint] : passed_) json[scene] = hexText(fingerprint);
    render::writeFileAtomically(file_, json.dump(1) + "\n");
}

}  // namespace demos
