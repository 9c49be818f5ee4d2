/// Parts of a film that other runs, perhaps on other machines, have drawn: --shard and join.
///   film.parts/003-of-016.mp4 and 003-of-016.json      frames/frame_000120.png ... and
///                                                      frames/run.003-of-016.json
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/film/frame_choice.h"
#include "demos/film/run_record.h"

namespace demos {

enum class PartState { missing, another, torn, done };

/// Of a film's part, for a run that would make `record`.
PartState stateOfPart(const std::filesystem::path& film, const RunRecord& record);

/// Beside the film, when that is whole. Throws render::Error.
void writePartRecord(const std::filesystem::path& film, RunRecord record);

/// A folder of parts, looked through.
struct Parts {
    int count = 0;                             // that there should be
    bool films = false;                        // or PNG frames
    std::vector<std::filesystem::path> files;  // of films, in order, where all are whole
    RunRecord whole;                           // what the run would have that draws all at once
    std::vector<int> wanted;                   // numbers of those to be made, or made again
    std::vector<std::string> troubles;         // "missing: 3 7", "of another program: 5"
};

/// Every part is read and compared with its hash. Throws Stop (usage) where there are none.
Parts partsIn(const std::filesystem::path& folder);

/// The command that makes the part `number`.
std::string commandOf(const Parts& parts, int number);

}  // namespace demos
