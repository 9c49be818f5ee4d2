#include "demos/film/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "demos/film/film_plan.h"
#include "demos/film/pattern.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"
#include "demos/text/shell_word.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::uint64_t hashOf(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = contentOf(file);
    if (bytes.empty()) return 0;
    TextHash hash;
    hash.add(bytes);
    return hash.value();
}

std::optional<RunRecord> recordAt(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = contentOf(file, kRunJson.bytes);
    return bytes.empty() ? std::nullopt : recordFromJson({bytes.begin(), bytes.end()});
}

/// A part found in the folder.
struct Found {
    Shard shard;
    fs::path film;  // empty: of PNG frames
    std::optional<RunRecord> record;
};

constexpr std::string_view kFrames = "run.";  // of the records of PNG frames

std::vector<Found> foundIn(const fs::path& folder) {
    std::vector<Found> all;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().extension() != ".json") continue;
        std::string name = entry.path().stem().string();
        const bool frames = name.starts_with(kFrames);
        if (frames) name.erase(0, kFrames.size());
        const std::optional<Shard> shard = shardNamed(name);
        if (!shard) continue;
        Found found{*shard, {}, recordAt(entry.path())};
        for (const char* ending : {".mp4", ".webm"})
            if (fs::path film = folder / (name + ending); !frames && fs::exists(film))
                found.film = film;
        all.push_back(std::move(found));
    }
    std::sort(all.begin(), all.end(),
              [](const Found& a, const Found& b) { return a.shard.number < b.shard.number; });
    return all;
}

/// All its frames are recorded, and its files match the record.
bool isWhole(const Found& found, const fs::path& folder) {
    if (!found.record || !found.record->finished) return false;
    const RunRecord& record = *found.record;
    const int frames = static_cast<int>(record.frames.size());
    for (int frame = found.shard.first(frames); frame < found.shard.end(frames); ++frame) {
        const FrameRecord& entry = record.frames[static_cast<std::size_t>(frame)];
        if (!entry.written) return false;
        if (record.film != 0) continue;
        const PatternValues values{frame, static_cast<double>(frame) / std::max(record.fps, 1),
                                   record.scene, record.quality};
        const fs::path name = fs::path(expandPattern(record.pattern, values)).filename();
        if (hashOf(folder / name) != entry.png) return false;
    }
    return record.film == 0 || hashOf(found.film) == record.film;
}

/// Run and its number of frames, program, pixels.
using Kind = std::tuple<std::pair<std::uint64_t, std::size_t>, std::string, std::string>;

Kind kindOf(const RunRecord& record) {
    return {{record.fingerprint, record.frames.size()},
            record.version + " " + record.renderer,
            record.pixels};
}

/// The kind of most parts.
Kind usualKind(const std::vector<Found>& all) {
    std::map<Kind, int> counts;
    for (const Found& found : all)
        if (found.record) ++counts[kindOf(*found.record)];
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? Kind{} : most->first;
}

std::string oddness(const Kind& kind, const Kind& usual) {
    if (std::get<2>(kind) != std::get<2>(usual))
        return "of another class of processors (--reproducible draws the same on all)";
    if (std::get<1>(kind) != std::get<1>(usual)) return "of another program or renderer";
    return "of another run";
}

/// Adds a part's frames to the whole.
void addPart(const Found& found, Parts& parts) {
    const int frames = static_cast<int>(found.record->frames.size());
    if (parts.whole.frames.empty()) {
        parts.whole = *found.record;
        parts.whole.frames.assign(static_cast<std::size_t>(frames), {});
    }
    parts.whole.addIncident(found.record->incident, found.record->incidentFrame);
    for (int frame = found.shard.first(frames); frame < found.shard.end(frames); ++frame)
        parts.whole.frames[static_cast<std::size_t>(frame)] =
            found.record->frames[static_cast<std::size_t>(frame)];
    if (!found.film.empty()) parts.files.push_back(found.film);
}

}  // namespace

FoundPart stateOfPart(const fs::path& film, const RunRecord& record) {
    const std::optional<RunRecord> old = recordAt(fs::path(film).replace_extension(".json"));
    if (!old) return {};
    if (old->fingerprint != record.fingerprint) return {PartState::another, {}};
    if (!old->finished || hashOf(film) != old->film) return {PartState::torn, {}};
    return {PartState::done, old->incident};
}

void writePartRecord(const fs::path& film, RunRecord record) {
    record.film = hashOf(film);
    record.pattern = film.filename().string();
    record.finished = true;
    const std::string json = jsonOf(record);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(json.data());
    render::writeFrameFile(fs::path(film).replace_extension(".json"), {bytes, json.size()});
}

Parts partsIn(const fs::path& folder) {
    const std::vector<Found> all = foundIn(folder);
    const std::string name = printable(folder.string());
    if (all.empty())
        refuse(fmt::format("'{}' has no parts; make them with impulse render --shard 1/N", name));
    Parts parts;
    parts.count = all.front().shard.count;
    parts.films =
        !all.front().film.empty() || (all.front().record && all.front().record->film != 0);
    for (const Found& found : all)
        if (found.shard.count != parts.count)
            refuse(fmt::format("'{}' has parts of {} and of {}; remove those that do not belong",
                               name, parts.count, found.shard.count));
    const Kind usual = usualKind(all);
    std::map<std::string, std::vector<int>> troubles;
    std::size_t next = 0;
    for (int number = 1; number <= parts.count; ++number) {
        const bool there = next < all.size() && all[next].shard.number == number;
        const Found* found = there ? &all[next++] : nullptr;
        const bool odd = found && found->record && kindOf(*found->record) != usual;
        const std::string trouble = !found ? "missing"
                                    : odd  ? oddness(kindOf(*found->record), usual)
                                    : isWhole(*found, folder) ? ""
                                                              : "torn or not finished";
        if (trouble.empty()) addPart(*found, parts);
        if (found && found->record && parts.whole.command.empty())
            parts.whole.command = found->record->command;
        if (trouble.empty()) continue;
        troubles[trouble].push_back(number);
        parts.wanted.push_back(number);
    }
    for (const auto& [what, numbers] : troubles)
        parts.troubles.push_back(fmt::format("{}: {}", what, fmt::join(numbers, " ")));
    return parts;
}

std::string commandOf(const Parts& parts, int number) {
    std::string command = parts.whole.command;
    // Records may come from other machines, and their commands are run.
    if (!command.starts_with("impulse render ") || !arePlainWords(command)) return {};
    const std::string option = "--shard";
    const std::size_t at = command.find(option);
    if (at == std::string::npos) return {};
    const std::size_t value = at + option.size() + 1;  // after a space or '='
    const std::size_t end = std::min(command.find(' ', value), command.size());
    return command.replace(value, end - value, fmt::format("{}/{}", number, parts.count));
}

}  // namespace demos
