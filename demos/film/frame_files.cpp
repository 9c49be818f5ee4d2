#include "demos/film/frame_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/data_json.h"
#include "demos/film/frame_choice.h"
#include "demos/film/outputs.h"
#include "demos/film/resume_states.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"
#include "demos/text/text_hash.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

bool isSymlink(const fs::path& path) {
    std::error_code ignored;
    return fs::is_symlink(fs::symlink_status(path, ignored));
}

/// Of a frame or a file of its data: far more than any has.
std::uintmax_t mostBytesOf(const PanelLayout& layout) {
    const auto pixels = static_cast<std::uintmax_t>(layout.width) * layout.height;
    return (std::uintmax_t{64} << 20) + 16 * pixels;
}

/// Removes files named `ENDING.tmp` and a number.
void sweep(const fs::path& folder, const std::vector<std::string>& endings) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const std::string stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
        for (const std::string& ending : endings)
            if (stem.ends_with(ending + ".tmp") &&
                entry.symlink_status(ignored).type() == fs::file_type::regular)
                fs::remove(entry.path(), ignored);
    }
}

void removeOwn(const fs::path& name) {
    std::error_code ignored;
    if (fs::is_regular_file(fs::symlink_status(name, ignored))) fs::remove(name, ignored);
}

}  // namespace

FrameFiles::FrameFiles(const FilmPlan& plan, const fs::path& folder, RunRecord record,
                       bool overwrite)
    : plan_(plan), folder_(folder), record_(std::move(record)) {
    record_.frames.assign(static_cast<std::size_t>(plan.frames), {});
    render::makeFolder(folder_);
    if (!isPart()) lock_.emplace(folder_);
    if (!isPart()) render::sweepTemporaries(recordName());
    const std::vector<std::uint8_t> bytes = contentOf(recordName(), kRunJson.bytes);
    const auto old = recordFromJson({bytes.begin(), bytes.end()});
    const bool same = old && old->pattern == record_.pattern;
    if (same && !isPart()) sweepTemporaries();
    if (overwrite && same) {
        removeOutdated(*old);
    } else if (!overwrite && same && old->fingerprint == record_.fingerprint) {
        takeUp(*old);
    } else if (!overwrite && (old || !bytes.empty())) {
        refuseToReplace(folder_,
                        "holds the frames of another run (other settings, scene or program); "
                        "--overwrite replaces them");
    } else if (!overwrite) {
        refuseStrangers();
    }
    checkData();
    close(false);  // the record first: what is written after it is known to be this run's
    prepareData();
}

fs::path FrameFiles::recordName() const {
    return folder_ / (isPart() ? "run." + record_.shard + ".json" : "run.json");
}

bool FrameFiles::hasAll() const {
    return std::all_of(record_.frames.begin(), record_.frames.end(),
                       [](const FrameRecord& frame) { return frame.written; });
}

bool FrameFiles::isGood(int frame, const FrameRecord& entry) const {
    if (!entry.written) return false;
    const std::vector<std::uint8_t> bytes = contentOf(nameOf(frame), mostBytesOf(plan_.layout));
    return render::pngIsWhole(bytes, plan_.layout.width, plan_.layout.height) &&
           hashOf(bytes) == entry.png && dataHash(frame) == entry.data;
}

bool FrameFiles::allGood(const RunRecord& old) const {
    if (old.frames.size() != record_.frames.size()) return false;
    for (std::size_t i = 0; i < old.frames.size(); ++i)
        if (old.frames[i].written && !isGood(static_cast<int>(i), old.frames[i])) return false;
    return true;
}

/// Hash of the frame's files of all passes; 0 if there are no passes.
std::uint64_t FrameFiles::dataHash(int frame) const {
    TextHash hash;
    for (const Pass pass : plan_.passes)
        hash.add(contentOf(nameOf(frame, pass), mostBytesOf(plan_.layout)));
    return plan_.passes.empty() ? 0 : hash.value();
}

/// Frames of two classes of processors are not mixed: all of another class are kept, or none.
void FrameFiles::takeUp(const RunRecord& old) {
    if (old.pixels != record_.pixels && !(old.finished && allGood(old))) return;
    record_.pixels = old.pixels;
    const std::size_t count = std::min(old.frames.size(), record_.frames.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (!isGood(static_cast<int>(i), old.frames[i])) continue;
        record_.frames[i] = old.frames[i];
        ++kept_;
    }
    record_.addIncident(old.incident, old.incidentFrame);
}

/// Frames without a record may be someone else's.
void FrameFiles::refuseStrangers() const {
    const auto check = [](const fs::path& name) {
        std::error_code ignored;
        if (fs::exists(fs::symlink_status(name, ignored)))
            refuseToReplace(name,
                            "already exists, and no run.json says who wrote it; "
                            "--overwrite replaces it");
    };
    const std::optional<Shard> shard = shardNamed(record_.shard);
    const int first = shard ? shard->first(plan_.frames) : 0;
    const int end = shard ? shard->end(plan_.frames) : plan_.frames;
    for (int frame = first; frame < end; ++frame) {
        check(nameOf(frame));
        for (const Pass pass : plan_.passes) check(nameOf(frame, pass));
    }
    if (!plan_.passes.empty() && !shard) check(dataName());
}

void FrameFiles::checkData() const {
    for (const Pass pass : plan_.passes) {
        const fs::path folder = nameOf(0, pass).parent_path();
        if (isSymlink(folder))
            throw render::Error(fmt::format(
                "cannot write into '{}': it is a symbolic link; remove it or name another folder",
                printable(folder.string())));
    }
    if (!plan_.passes.empty()) render::checkReplaceable(dataName());
}

/// Makes a folder for each pass and writes their description.
void FrameFiles::prepareData() const {
    for (const Pass pass : plan_.passes) render::makeFolder(nameOf(0, pass).parent_path());
    if (!plan_.passes.empty())
        render::writeFileAtomically(dataName(), passesJson(plan_, record_.pattern));
}

/// Removes what a killed run was writing. The lock ensures that nobody is writing it now.
void FrameFiles::sweepTemporaries() const {
    sweep(folder_, {".png", "run.json", "passes.json"});
    for (const PassText& text : passTexts())
        if (const fs::path folder = folder_ / text.name; !isSymlink(folder))
            sweep(folder, {text.ending});
}

/// A shorter film must not end with frames of the old one, nor keep its data.
void FrameFiles::removeOutdated(const RunRecord& old) const {
    const int oldFrames = static_cast<int>(old.frames.size());
    const std::optional<Shard> shard = shardNamed(record_.shard);
    const int first = shard ? shard->first(oldFrames) : 0, end = shard ? shard->end(oldFrames) : oldFrames;
    for (int frame = std::max(plan_.frames, first); frame < end; ++frame) removeOwn(nameOf(frame));
    for (const Pass pass : passesCalled(old.passes)) {
        if (isSymlink(folder_ / textOf(pass).name)) continue;
        for (int frame = first; frame < end; ++frame) removeOwn(nameOf(frame, pass));
        std::error_code ignored;
        fs::remove(folder_ / textOf(pass).name, ignored);  // if nothing else is in it
    }
    if (!old.passes.empty() && !shard) removeOwn(dataName());
}

fs::path FrameFiles::nameOf(int frame) const {
    const fs::path name = expandPattern(record_.pattern, valuesOf(plan_, frame));
    return folder_ / name.filename();
}

fs::path FrameFiles::nameOf(int frame, Pass pass) const {
    const PassText& text = textOf(pass);
    return folder_ / text.name / (nameOf(frame).stem().string() + text.ending);
}

/// Returns the hash of what it writes.
std::uint64_t FrameFiles::addData(const DrawnFrame& frame) {
    TextHash hash;
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        render::writeFrameFile(nameOf(frame.frame, plan_.passes[i]), frame.data.at(i));
        hash.add(frame.data[i]);
    }
    return plan_.passes.empty() ? 0 : hash.value();
}

void FrameFiles::add(const DrawnFrame& frame) {
    if (has(frame.frame)) return;
    const std::uint64_t data = addData(frame);
    render::writeFrameFile(nameOf(frame.frame), frame.png);
    record_.frames[frame.frame] = {true, frame.stateHash, hashOf(frame.png), data};
    record_.addIncident(frame.incident, frame.frame);
    // Seldom enough that a long film's record costs little, often enough that little is redrawn.
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - recorded_;
    const double most = std::max(kResumeEvery, 20.0 * recording_);
    if (++unrecorded_ >= std::max(50, plan_.frames / 64) || time.count() > most) close(false);
}

void FrameFiles::close(bool finished) {
    const auto start = std::chrono::steady_clock::now();
    record_.finished = finished && (isPart() || hasAll());
    const std::string json = jsonOf(record_);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(json.data());
    render::writeFrameFile(recordName(), {bytes, json.size()});
    unrecorded_ = 0;
    recorded_ = std::chrono::steady_clock::now();
    recording_ = std::chrono::duration<double>(recorded_ - start).count();
    if (!finished) removeStatesBefore(firstMissing(), plan_);
}

int FrameFiles::firstMissing() const {
    const std::optional<Shard> shard = shardNamed(record_.shard);
    const int end = shard ? shard->end(plan_.frames) : plan_.frames;
    int frame = shard ? shard->first(plan_.frames) : 0;
    while (frame < end && record_.frames[frame].written) ++frame;
    return frame;
}

}  // namespace demos
