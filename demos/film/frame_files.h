/// A numbered sequence of PNG files in a folder, and the run.json beside them.
#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/film/frame_source.h"
#include "demos/film/run_record.h"
#include "demos/processes/folder_lock.h"

namespace demos {

/// Holds the folder's lock for its lifetime, except for a part: other parts are written to the same
/// folder at the same time, perhaps by other machines.
class FrameFiles {
public:
    /// `record`: describes this run. Resumes a run with the same fingerprint: complete frames with
    /// the recorded content are kept. Throws Stop (wouldOverwrite) when the folder holds
    /// another run's frames and `overwrite` is not set, or is being written by another process.
    FrameFiles(const FilmPlan& plan, const std::filesystem::path& folder, RunRecord record,
               bool overwrite);
    FrameFiles(const FrameFiles&) = delete;
    FrameFiles& operator=(const FrameFiles&) = delete;

    bool has(int frame) const { return record_.frames[frame].written; }
    bool hasAll() const;
    int kept() const { return kept_; }
    const RunRecord& record() const { return record_; }
    /// Writes the frame, and from time to time the record.
    void add(const DrawnFrame& frame);
    /// Writes the record.
    void close(bool finished);
    std::filesystem::path nameOf(int frame) const;
    /// The file that describes the data passes.
    std::filesystem::path dataName() const { return folder_ / "passes.json"; }
    const std::filesystem::path& folder() const { return folder_; }

private:
    void checkData() const;
    void prepareData() const;
    std::filesystem::path nameOf(int frame, Pass pass) const;
    std::uint64_t dataHash(int frame) const;
    std::uint64_t addData(const DrawnFrame& frame);
    void takeUp(const RunRecord& old);
    void refuseStrangers() const;
    void sweepTemporaries() const;
    void removeOutdated(const RunRecord& old) const;
    bool isGood(int frame, const FrameRecord& entry) const;
    bool allGood(const RunRecord& old) const;
    int firstMissing() const;
    bool isPart() const { return !record_.shard.empty(); }
    std::filesystem::path recordName() const;

    const FilmPlan& plan_;
    std::filesystem::path folder_;
    RunRecord record_;
    std::optional<FolderLock> lock_;
    int kept_ = 0;
    int unrecorded_ = 0;
    std::chrono::steady_clock::time_point recorded_;
    double recording_ = 0.0;  // s, the last time
};

}  // namespace demos
