#include "demos/film/parts.h"

#include <algorithm>
#include <optional>

#include "demos/film/data_pass.h"
#include "demos/film/film_plan.h"
#include "demos/film/part_review.h"
#include "demos/film/pattern.h"
#include "demos/text/file_content.h"
#include "demos/text/hex_text.h"
#include "demos/text/json_limits.h"
#include "demos/text/text_hash.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::optional<RunRecord> recordAt(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = contentOf(file, kRunJson.bytes);
    return bytes.empty() ? std::nullopt : recordFromJson({bytes.begin(), bytes.end()});
}

constexpr std::uintmax_t kMostFrameBytes = 2u << 30;  // of 16384x16384 pixels without compression

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

/// Of a frame's files of all passes; 0 if there are none, and for passes that do not exist.
std::uint64_t dataHash(const RunRecord& record, const fs::path& png) {
    const std::vector<std::string> known = passNames();
    TextHash hash;
    for (const std::string& name : record.passes) {
        if (std::ranges::find(known, name) == known.end()) return 0;
        const PassText& text = textOf(passesCalled({name}).front());
        hash.add(contentOf(png.parent_path() / text.name / (png.stem().string() + text.ending)));
    }
    return record.passes.empty() ? 0 : hash.value();
}

/// All its frames are recorded, and its files match the record.
bool isWhole(const Found& found, const fs::path& folder) {
    if (!found.record || !found.record->finished || found.record->frames.empty()) return false;
    const RunRecord& record = *found.record;
    const int frames = static_cast<int>(record.frames.size());
    for (int frame = found.shard.first(frames); frame < found.shard.end(frames); ++frame) {
        const FrameRecord& entry = record.frames[static_cast<std::size_t>(frame)];
        if (!entry.written) return false;
        if (record.film != 0) continue;
        const fs::path png = frameFile(record, folder, frame);
        if (hashOfFile(png, kMostFrameBytes) != entry.png || dataHash(record, png) != entry.data) return false;
    }
    return record.film == 0 || hashOfFile(found.film) == record.film;
}

PartSeen seenOf(const Found& found, const fs::path& folder) {
    PartSeen seen{found.shard, found.record.has_value(), isWhole(found, folder), 0, "", ""};
    if (!found.record) return seen;
    const RunRecord& record = *found.record;
    TextHash run;
    run.add(hexText(record.fingerprint));
    run.add(std::to_string(record.frames.size()));
    seen.run = run.value();
    seen.program = record.version + " " + record.renderer;
    seen.pixels = record.pixels;
    return seen;
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
    if (old->fingerprint != record.fingerprint) return {PartState::another, {}, {}};
    if (!old->finished || hashOfFile(film) != old->film) return {PartState::damaged, {}, {}};
    return {PartState::done, old->incident, old->pixels};
}

void writePartRecord(const fs::path& film, RunRecord record) {
    record.film = hashOfFile(film);
    record.pattern = film.filename().string();
    record.finished = true;
    const std::string json = jsonOf(record);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(json.data());
    render::writeFrameFile(fs::path(film).replace_extension(".json"), {bytes, json.size()});
}

Parts partsIn(const fs::path& folder) {
    const std::vector<Found> all = foundIn(folder);
    std::vector<PartSeen> seen;
    for (const Found& found : all) seen.push_back(seenOf(found, folder));
    const PartReview review = reviewed(seen, folder.string());
    Parts parts;
    parts.count = review.count;
    parts.films =
        !all.front().film.empty() || (all.front().record && all.front().record->film != 0);
    parts.wanted = review.wanted;
    parts.foreign = review.foreign;
    parts.troubles = review.troubles;
    for (const std::size_t i : review.good) addPart(all[i], parts);
    for (const Found& found : all)
        if (found.record && parts.whole.command.empty())
            parts.whole.command = found.record->command;
    return parts;
}

std::string commandOf(const Parts& parts, int number) {
    constexpr std::string_view kReplace = " --overwrite";
    std::string command = commandOf(parts.whole.command, "impulse render ", {number, parts.count});
    if (const std::size_t at = command.find(kReplace); at != command.npos) command.erase(at, kReplace.size());
    const bool replaces = std::ranges::find(parts.foreign, number) != parts.foreign.end();
    return replaces && !command.empty() ? command.append(kReplace) : command;
}

fs::path frameFile(const RunRecord& record, const fs::path& folder, int frame) {
    const PatternValues values{frame, static_cast<double>(frame) / std::max(record.fps, 1), record.scene,
                               record.quality};
    return folder / fs::path(expandPattern(record.pattern, values)).filename();
}

}  // namespace demos
