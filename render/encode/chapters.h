/// The chapters of a film, which players list and jump to.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace render {

/// The frames first..end-1 of a film.
struct Chapter {
    int first = 0;     ///< Its first frame.
    int end = 0;       ///< The frame after its last one.
    std::string name;  ///< UTF-8.
};

/// Arguments of ffmpeg for one more input, which gives the film its chapters; none without them.
/// Empty chapters and those after the 255th, which .mp4 cannot hold, are left out; long names are
/// cut.
std::vector<std::string> chapterInput(std::span<const Chapter> chapters, int fps);

/// Arguments for the output: these chapters, from the input with this number, and no other metadata.
std::vector<std::string> chapterOutput(std::span<const Chapter> chapters, int input);

}  // namespace render
