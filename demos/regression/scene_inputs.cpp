#include "demos/regression/scene_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "demos/load/load_scene.h"
#include "demos/regression/run_settings.h"
#include "demos/scene/reader.h"
#include "demos/text/base64.h"
#include "demos/text/complaints.h"
#include "demos/text/deflate.h"
#include "demos/text/hex_text.h"
#include "demos/text/text_hash.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOldBaseline =
    "the baseline is older than this program: it has no loads and no values of the scene to "
    "compare; impulse test --update all renews it";
constexpr std::size_t kMostChanges = 100;
constexpr std::size_t kMostInputs = 16u << 20;  // bytes; a scene's files have 8 MiB at most

using Entry = std::pair<std::string, std::string>;

/// "[1, 2, 0]" as three texts; nothing if it is no list, or holds others.
std::vector<std::string> numbersIn(const std::string& list) {
    if (!list.starts_with('[') || list.find('[', 1) != list.npos || !list.ends_with(']')) return {};
    std::vector<std::string> items;
    for (std::size_t at = 1; at < list.size();) {
        const std::size_t end = std::min(list.find(", ", at), list.size() - 1);
        items.push_back(list.substr(at, end - at));
        at = end + (list[end] == ',' ? 2 : 1);
    }
    return items;
}

class InputComparison {
public:
    std::vector<SettingChange> changes;

    void compare(const Settings& baseline, const Settings& actual) {
        auto was = baseline.begin(), is = actual.begin();
        while (was != baseline.end() || is != actual.end()) {
            const bool gone =
                is == actual.end() || (was != baseline.end() && was->first < is->first);
            const bool added =
                was == baseline.end() || (is != actual.end() && is->first < was->first);
            if (gone) only(*was, true), was = afterTable(was, baseline.end());
            if (added) only(*is, false), is = afterTable(is, actual.end());
            if (!gone && !added) both(*was++, *is++);
        }
    }

private:
    void only(const Entry& entry, bool gone) {
        if (entry.second.starts_with("[["))
            changes.push_back({entry.first + (gone ? " is gone" : " is new"), "", ""});
        else
            changes.push_back({entry.first, gone ? entry.second : "", gone ? "" : entry.second});
    }

    /// The next entry that is not in the table that begins here. Its keys follow, but so may those
    /// of tables whose names begin alike.
    template <class Iterator>
    static Iterator afterTable(Iterator at, Iterator end) {
        const Entry& first = *at++;
        if (!first.second.starts_with("[[")) return at;
        while (at != end && at->first.starts_with(first.first + ".")) ++at;
        return at;
    }

    void both(const Entry& was, const Entry& is) {
        if (was.second == is.second) return;
        const std::vector<std::string> before = numbersIn(was.second), after = numbersIn(is.second);
        if (before.empty() || before.size() != after.size())
            return changes.push_back({was.first, was.second, is.second});
        for (std::size_t i = 0; i < before.size(); ++i)
            if (before[i] != after[i])
                changes.push_back({fmt::format("{}[{}]", was.first, i), before[i], after[i]});
    }
};

}  // namespace

Settings inputsOf(const SceneDescription& scene, const std::string& name,
                  const std::vector<std::string>& overrides) {
    Settings inputs = valuesOf(name, overrides);
    const auto addFile = [&inputs](const std::string& file) {
        inputs.emplace_back(
            "file " + printable(fs::path(file).filename().string()),
            hexText(hashOf(readSceneFile(file, "a file of the scene", kMostPartBytes))));
    };
    if (fs::path(name).extension() == ".xml") addFile(name);
    for (const std::string& file : scene.files)
        if (fs::path(file).extension() != ".toml") addFile(file);
    std::sort(inputs.begin(), inputs.end());
    return inputs;
}

std::vector<SettingChange> changedInputs(const Settings& baseline, const Settings& actual) {
    InputComparison comparison;
    comparison.compare(baseline, actual);
    std::vector<SettingChange> changes = std::move(comparison.changes);
    if (changes.size() <= kMostChanges) return changes;
    const std::size_t more = changes.size() - kMostChanges;
    changes.resize(kMostChanges);
    changes.push_back({fmt::format("{} more values", more), "", ""});
    return changes;
}

std::vector<SettingChange> changesBetween(const Baseline& baseline, const Baseline& actual) {
    std::vector<SettingChange> changes = changesOf(baseline.settings, actual.settings);
    // An older baseline has a hash of the scene file, which tells nothing.
    std::erase_if(changes, [](const SettingChange& c) { return c.key == "scene file"; });
    if (baseline.inputs.empty()) {
        changes.push_back({kOldBaseline, "", ""});
        return changes;
    }
    const auto isListed = [settings = changes](const SettingChange& change) {
        const std::string key = change.key.substr(0, change.key.find('['));
        return std::ranges::any_of(settings, [&key](const SettingChange& c) { return c.key == key; });
    };
    for (SettingChange& change : changedInputs(baseline.inputs, actual.inputs))
        if (!isListed(change)) changes.push_back(std::move(change));
    return changes;
}

std::string deflatedInputs(const Settings& inputs) {
    std::string text;
    for (const auto& [key, value] : inputs) text += key + "\t" + value + "\n";
    if (text.size() > kMostInputs) text = "all values\t" + hexText(hashOf(text)) + "\n";
    return toBase64(deflated({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

Settings inflatedInputs(const std::string& packed) {
    const std::optional<std::string> bytes = fromBase64(packed);
    if (!bytes) throw std::invalid_argument("base64");
    const auto plain = inflated(
        {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()}, kMostInputs);
    if (!plain) throw std::invalid_argument("inputs");
    const std::string_view text(reinterpret_cast<const char*>(plain->data()), plain->size());
    Settings inputs;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t tab = text.find('\t', at), end = text.find('\n', at);
        if (tab >= end || end == text.npos) throw std::invalid_argument("inputs");
        inputs.emplace_back(text.substr(at, tab - at), text.substr(tab + 1, end - tab - 1));
        at = end + 1;
    }
    return inputs;
}

}  // namespace demos
