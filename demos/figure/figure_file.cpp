#include "demos/figure/figure_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/outputs.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "demos/text/table.h"
#include "render/encode/file.h"

namespace demos {
namespace {

std::string besideOf(const std::string& picture) {
    return std::filesystem::path(picture).replace_extension(".caption.txt").string();
}

void checkCaption(const std::string& caption, const std::vector<std::string>& pictures) {
    if (caption == "-")
        throw Stop(Exit::usage, "--caption '-': a caption needs a file; give it a name");
    for (const std::string& picture : pictures)
        if (placeOf(picture) == placeOf(caption))
            throw Stop(Exit::usage,
                       fmt::format("--caption '{}': the figure itself goes there; give "
                                   "another name",
                                   printable(caption)));
}

}  // namespace

std::vector<std::string> captionFiles(const std::vector<std::string>& pictures,
                                      const Options& options) {
    if (!options.caption.empty()) return {options.caption};
    std::vector<std::string> files;
    for (const std::string& picture : pictures) {
        const std::string file = besideOf(picture);
        const bool wanted = options.width && picture != "-";
        if (wanted && std::find(files.begin(), files.end(), file) == files.end())
            files.push_back(file);
    }
    return files;
}

void checkFigure(const std::vector<std::string>& pictures, const Options& options) {
    const std::vector<std::string> captions = captionFiles(pictures, options);
    for (const std::string& caption : captions) checkCaption(caption, pictures);
    for (const std::string& picture : pictures) checkFree(picture, options.overwrite);
    for (const std::string& caption : captions) checkFree(caption, options.overwrite);
}

render::Existing existingPlots(const std::vector<std::string>& plots, const Options& options) {
    return existingFiles(options.overwrite || captionFiles(plots, options).empty());
}

void writeFigure(const std::vector<FigurePicture>& pictures, const std::string& caption,
                 const Options& options, render::Existing existing) {
    std::vector<std::string> names;
    std::vector<render::NamedBytes> files;
    for (const FigurePicture& picture : pictures) {
        names.push_back(picture.file);
        if (picture.file != "-") files.push_back({picture.file, picture.bytes});
    }
    const auto* text = reinterpret_cast<const std::uint8_t*>(caption.data());
    for (const std::string& name : captionFiles(names, options))
        files.push_back({name, {text, caption.size()}});
    for (const render::NamedBytes& file : files) render::makeFolder(file.path.parent_path());
    render::writeFilesTogether(files, existing);
    for (const FigurePicture& picture : pictures)
        if (picture.file == "-") writeResult("-", picture.bytes);
}

void reportCaptions(const std::vector<std::string>& pictures, const Options& options,
                  const Talk& talk) {
    for (const std::string& file : captionFiles(pictures, options)) {
        talk.say(fmt::format("wrote {}", printable(file)));
        talk.json(fmt::format(R"({{"event":"caption","file":{}}})", jsonString(file)));
    }
}

}  // namespace demos
