/// Where a run goes: the ending of a file picks what is written.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/export/trajectory.h"
#include "demos/options.h"

namespace demos {

enum class ExportKind { glb, csv, npz, events, replay };

struct ExportFile {
    ExportKind kind = ExportKind::glb;
    std::string name;
};

/// Those of -o, or the default. Throws Stop (usage, wouldOverwrite) or render::Error for what
/// cannot be written, or twice to one place.
std::vector<ExportFile> exportFilesOf(const Options& options, const SceneDescription& scene);

/// Whole or not at all; returns its size in bytes. Of all but a replay. Throws render::Error.
std::size_t writeExport(const ExportFile& file, const Stage& stage, const Trajectory& trajectory);

}  // namespace demos
