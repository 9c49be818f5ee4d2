/// Where a run goes: the ending of a file picks what is written.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/export/recording.h"
#include "demos/options/options.h"
#include "render/encode/file.h"

namespace demos {

enum class ExportKind { glb, csv, npz, events, replay };

struct ExportFile {
    ExportKind kind = ExportKind::glb;
    std::string name;
};

/// Those of -o, or the default. Throws Stop (usage, wouldOverwrite) or render::Error for what
/// cannot be written, or twice to one place.
std::vector<ExportFile> exportFilesOf(const Options& options, const SceneDescription& scene);

struct WrittenExport {
    std::size_t bytes = 0;
    std::string left;  // what a replay had to leave out, for a line on the screen; empty: nothing
};

/// Whole or not at all. `stage`: whose run it is. Throws render::Error.
WrittenExport writeExport(const ExportFile& file, const Stage& stage, const Recording& recording,
                          render::Existing existing);

}  // namespace demos
