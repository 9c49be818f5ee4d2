#include "demos/film/resume_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "demos/film/state_files.h"
#include "demos/measures/clock.h"
#include "demos/processes/signals.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// Never through a symlink.
bool isFolder(const fs::path& folder) {
    std::error_code ignored;
    return fs::symlink_status(folder, ignored).type() == fs::file_type::directory;
}

/// Calls visit(file, name) for the folder's files.
template <class Visit>
void eachFile(const fs::path& folder, const Visit& visit) {
    std::error_code ignored;
    std::vector<fs::path> files;
    if (isFolder(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
            files.push_back(entry.path());
    for (const fs::path& file : files) visit(file, file.filename().string());
}

/// Also what a killed run was writing: "000240.state.tmp123".
bool isOurs(const std::string& name) {
    const std::string stem = name.substr(0, name.find(".state"));
    const bool numbered = !stem.empty() && std::ranges::all_of(stem, [](char c) { return c >= '0' && c <= '9'; });
    const std::string rest = name.substr(std::min(stem.size(), name.size()));
    return (numbered || stem == "camera") && (rest == ".state" || rest.starts_with(".state.tmp"));
}

void makeResumeFolder(const FilmPlan& plan) {
    render::makeFolder(plan.resume);
    if (!isFolder(plan.resume)) throw render::Error(plan.resume + ": is a symbolic link");
}

}  // namespace

void planToResume(const std::vector<Output>& outputs, const FilmOptions& options, FilmPlan& plan) {
    const auto isFrames = [](const Output& output) { return output.kind == OutputKind::frames; };
    const auto frames = std::ranges::find_if(outputs, isFrames);
    if (frames == outputs.end() || !needsOneState(plan) || !options.frames.empty()) return;
    const std::string part = options.shard ? "." + options.shard->name() : "";
    plan.resume = (frames->path / (".impulse-resume" + part)).string();
    plan.stateKind = stateKindOf(plan.scene(), options);
    if (plan.states.empty() && isFolder(plan.resume) && !options.overwrite) plan.states = plan.resume;
}

bool fitForLong(FilmPlan& plan, const FilmOptions& options) {
    const double before = processorTime();
    fitCameras(plan);
    if (interrupted())  // the motion of a run that was cut short
        throw Stop(Exit::interrupted,
                   fmt::format("interrupted before the first frame; to run it again: {}", options.commandLine));
    return processorTime() - before > kResumeEvery;
}

void keepCamera(const FilmPlan& plan) try {
    if (plan.resume.empty()) return;
    makeResumeFolder(plan);
    writeCamera(plan.resume, plan.stateKind, plan.scene(), plan.scene().camera);
} catch (const render::Error&) {  // the film does not need it
}

void removeStatesBefore(int frame, const FilmPlan& plan) {
    if (plan.resume.empty()) return;
    std::vector<std::pair<long long, fs::path>> before;
    const int most = plan.stepOf(plan.shutter.moments > 1 ? frame - 1 : frame);
    eachFile(plan.resume, [&](const fs::path& file, const std::string&) {
        if (const std::optional<long long> step = stepOfState(file); step && *step <= most)
            before.push_back({*step, file});
    });
    std::ranges::sort(before);
    std::error_code ignored;
    for (std::size_t i = 0; i + 1 < before.size(); ++i) fs::remove(before[i].second, ignored);
}

void clearStates(const FilmPlan& plan) {
    if (plan.resume.empty()) return;
    std::error_code ignored;
    eachFile(plan.resume, [&](const fs::path& file, const std::string& name) {
        if (isOurs(name)) fs::remove(file, ignored);
    });
    if (isFolder(plan.resume)) fs::remove(plan.resume, ignored);
}

void ResumeStates::begin() { begin_ = processorTime(); }

void ResumeStates::end(const Composite& composite) try {
    unsaved_ += processorTime() - begin_;
    if (plan_.resume.empty() || unsaved_ < every_) return;
    unsaved_ = 0.0;
    makeResumeFolder(plan_);
    composite.writeState(plan_.resume, memory_);
} catch (const render::Error&) {  // the film does not need it
}

}  // namespace demos
