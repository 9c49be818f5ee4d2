/// The files of a figure: pictures, and a caption next to each. All are written or none.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/film/progress.h"
#include "demos/options/options.h"
#include "render/encode/file.h"

namespace demos {

/// Where the captions of these pictures go: --caption, else next to each picture that has a width
/// (fig.png: fig.caption.txt); none for standard output.
std::vector<std::string> captionFiles(const std::vector<std::string>& pictures,
                                      const Options& options);

/// Throws Stop (usage) if a caption would go to a picture's file or to standard output, Stop
/// (wouldOverwrite) if one of the files exists.
void checkFigure(const std::vector<std::string>& pictures, const Options& options);

struct FigurePicture {
    std::string file;  // or "-"
    std::vector<std::uint8_t> bytes;
};

/// What to do with existing plots: those without a caption are always replaced.
render::Existing existingPlots(const std::vector<std::string>& plots, const Options& options);

/// Makes the folders. Throws render::Error.
void writeFigure(const std::vector<FigurePicture>& pictures, const std::string& caption,
                 const Options& options, render::Existing existing);

/// Prints a line for every caption that was written.
void reportCaptions(const std::vector<std::string>& pictures, const Options& options,
                  const Talk& talk);

}  // namespace demos
