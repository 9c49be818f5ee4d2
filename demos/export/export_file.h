/// The files of an export: the extension of a name selects the format.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/export/recording.h"
#include "demos/options/options.h"
#include "render/encode/files_together.h"

namespace demos {

enum class ExportKind { glb, csv, npz, events, replay };

struct ExportFile {
    ExportKind kind = ExportKind::glb;
    std::string name;
};

/// The files of -o, or the default. Throws Stop (usage, wouldOverwrite) or render::Error for a file
/// that cannot be written or is given twice.
std::vector<ExportFile> exportFilesOf(const Options& options, const SceneDescription& scene);

struct WrittenExport {
    std::size_t bytes = 0;
    std::string left;  // what a replay had to leave out, to be reported; empty: nothing
};

/// Adds the file to those that are written together. `stage`: of the run. Throws render::Error.
WrittenExport writeExport(const ExportFile& file, const Stage& stage, const Recording& recording,
                          render::FilesTogether& together);

}  // namespace demos
