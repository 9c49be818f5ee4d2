#include "demos/film/resume_states.h"

#include <algorithm>
#include <system_error>

#include "demos/film/film_options.h"
#include "demos/measures/clock.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKept = 3;  // the newest are ahead of the frames that are recorded

/// Never through a symlink.
bool isFolder(const fs::path& folder) {
    std::error_code ignored;
    return fs::symlink_status(folder, ignored).type() == fs::file_type::directory;
}

std::vector<fs::path> statesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ignored;
    if (isFolder(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
            if (entry.path().extension() == ".state") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Of the run's states all but the last before this one; they are numbered by steps.
void removeOld(const fs::path& folder) {
    std::vector<fs::path> files = statesIn(folder);
    std::erase_if(files, [](const fs::path& file) { return file.filename() == "camera.state"; });
    std::error_code ignored;
    for (std::size_t i = 0; i + kKept < files.size(); ++i) fs::remove(files[i], ignored);
}

}  // namespace

void planToResume(const std::vector<Output>& outputs, const FilmOptions& options, FilmPlan& plan) {
    const auto isFrames = [](const Output& output) { return output.kind == OutputKind::frames; };
    const auto frames = std::ranges::find_if(outputs, isFrames);
    if (frames == outputs.end() || !needsOneState(plan)) return;
    const std::string name = options.shard ? "resume." + options.shard->name() : "resume";
    plan.resume = (frames->path / name).string();
    plan.stateKind = stateKindOf(plan.scene(), options);
    if (plan.states.empty() && isFolder(plan.resume) && !options.overwrite) plan.states = plan.resume;
}

void fitAndKeepCamera(FilmPlan& plan) {
    const double before = processorTime();
    fitCameras(plan);
    if (plan.resume.empty() || processorTime() - before < kResumeEvery) return;
    render::makeFolder(plan.resume);
    if (isFolder(plan.resume)) writeCamera(plan.resume, plan.stateKind, plan.scene(), plan.scene().camera);
}

void clearStates(const FilmPlan& plan) {
    std::error_code ignored;
    for (const fs::path& file : statesIn(plan.resume)) fs::remove(file, ignored);
    if (isFolder(plan.resume)) fs::remove(plan.resume, ignored);
}

void ResumeStates::begin() { begin_ = processorTime(); }

void ResumeStates::end(const Composite& composite) try {
    unsaved_ += processorTime() - begin_;
    if (plan_.resume.empty() || unsaved_ < every_) return;
    unsaved_ = 0.0;
    render::makeFolder(plan_.resume);
    if (!isFolder(plan_.resume)) return;
    composite.writeState(plan_.resume, memory_);
    removeOld(plan_.resume);
} catch (const render::Error&) {  // the film does not need it
}

}  // namespace demos
