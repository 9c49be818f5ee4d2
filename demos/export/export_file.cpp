#include "demos/export/export_file.h"

#include <span>
#include <string_view>
#include <utility>

#include "demos/export/glb_scene.h"
#include "demos/export/npz.h"
#include "demos/export/pose_table.h"
#include "demos/export/replay_page.h"
#include "demos/film/pattern.h"

namespace demos {
namespace {

constexpr std::pair<const char*, ExportKind> kEndings[] = {{".glb", ExportKind::glb},
                                                           {".csv", ExportKind::csv},
                                                           {".npz", ExportKind::npz},
                                                           {".json", ExportKind::events},
                                                           {".html", ExportKind::replay}};

ExportFile fileOf(const std::string& name) {
    if (name.find('\0') != std::string::npos) refuseOutput(name, "a name cannot contain NUL");
    for (const auto& [ending, kind] : kEndings)
        if (name.ends_with(ending)) return {kind, name};
    refuseOutput(name, "the file extension selects the format; known are: .glb .csv .npz .json .html");
}

/// Refuses to overwrite a file that the scene reads.
void spareSources(const std::string& name, const SceneDescription& scene) {
    for (const std::string& source : scene.files) {
        std::error_code neither;  // one of them may not exist
        if (std::filesystem::equivalent(name, source, neither))
            refuseOutput(name, "the scene reads this file; write to another one");
    }
}

std::vector<std::uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

std::vector<std::uint8_t> contentOf(const ExportFile& file, const Stage& stage,
                                    const Recording& recording, std::string& left) {
    switch (file.kind) {
        case ExportKind::glb:
            return glbOf(recording);
        case ExportKind::csv:
            return bytesOf(poseTable(file.name, recording).text());
        case ExportKind::npz:
            return npzOf(recording);
        case ExportKind::events:
            return bytesOf(eventsJson(recording.events, stage) + "\n");
        case ExportKind::replay:
            break;
    }
    const ReplayPage page = replayPage(recording);
    left = page.left;
    return bytesOf(page.html);
}

}  // namespace

std::vector<ExportFile> exportFilesOf(const Options& options, const SceneDescription& scene) {
    std::vector<std::string> names = options.outputs;
    if (names.empty()) names = {"output/" + scene.name + ".glb"};
    std::vector<ExportFile> files;
    for (const std::string& name : names) {
        const ExportFile file = fileOf(name);
        for (const ExportFile& other : files)
            if (placeOf(other.name) == placeOf(name))
                refuseOutput(name, "another --output goes there already");
        spareSources(name, scene);
        files.push_back(file);
    }
    for (const ExportFile& file : files) checkFree(file.name, options.overwrite);
    return files;
}

WrittenExport writeExport(const ExportFile& file, const Stage& stage, const Recording& recording,
                          render::FilesTogether& together) {
    WrittenExport written;
    const std::vector<std::uint8_t> content = contentOf(file, stage, recording, written.left);
    render::makeFolder(std::filesystem::path(file.name).parent_path());
    render::sweepTemporaries(file.name);
    together.add({file.name, content});
    written.bytes = content.size();
    return written;
}

}  // namespace demos
