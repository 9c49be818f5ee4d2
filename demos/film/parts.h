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

enum class PartState { missing, another, damaged, done };

struct FoundPart {
    PartState state = PartState::missing;
    std::string incident;  // of its simulation, if it is done
    std::string pixels;    // the class of processors that drew it, if it is done
};

/// The state of a film's part, for a run that would write `record`; done also if another class of
/// processors has drawn it.
FoundPart stateOfPart(const std::filesystem::path& film, const RunRecord& record);

/// Written next to the part's film when that is complete. Throws render::Error.
void writePartRecord(const std::filesystem::path& film, RunRecord record);

/// What partsIn() finds in a folder.
struct Parts {
    int count = 0;                             // of the whole film
    bool films = false;                        // false: PNG frames
    std::vector<std::filesystem::path> files;  // films of the good parts, in order
    RunRecord whole;                           // the record of a run that draws all at once
    std::vector<int> wanted;                   // numbers of the parts to draw, or draw again
    std::vector<int> foreign;                  // those of them that replace a part
    std::vector<std::string> troubles;         // "missing: 3 7", "of another program: 5"
};

/// Reads every part and compares it with its hash. Throws Stop (usage) if there are none.
Parts partsIn(const std::filesystem::path& folder);

/// The command that draws part `number`.
std::string commandOf(const Parts& parts, int number);

/// A PNG frame of a recorded run, in the folder of its record.
std::filesystem::path frameFile(const RunRecord& record, const std::filesystem::path& folder, int frame);

}  // namespace demos
