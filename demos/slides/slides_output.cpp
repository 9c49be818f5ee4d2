#include "demos/slides/slides_output.h"

#include <filesystem>

#include "demos/film/pattern.h"
#include "demos/slides/deck_files.h"
#include "demos/text/table.h"

namespace demos {
namespace {

SlidesOutput outputOf(const std::string& name) {
    if (name.find('\0') != std::string::npos) refuseOutput(name, "a name holds no NUL");
    const std::filesystem::path path = name;
    const std::string ending = path.extension();
    const bool file = ending == ".html" || ending == ".pdf" || ending == ".pptx";
    std::error_code ignored;
    const bool folder = std::filesystem::is_directory(path, ignored);
    if (file && folder && path.has_filename())
        refuseOutput(name,
                     "a folder is there; write to another name, or end it in / for its slides");
    if (folder || name.ends_with('/')) return {SlidesKind::folder, name};
    if (ending == ".pdf") return {SlidesKind::pdf, name};
    if (ending == ".pptx") return {SlidesKind::pptx, name};
    if (file) return {SlidesKind::page, name};
    refuseOutput(name, "the file extension selects the format; known are: .html .pdf .pptx and / of "
                 "a folder");
}

void spareSources(const std::string& name, const Deck& deck) {
    for (const std::filesystem::path& source : deck.files) {
        std::error_code neither;  // set if one of them does not exist
        if (std::filesystem::equivalent(name, source, neither))
            refuseOutput(name, "the deck reads this file; write to another one");
    }
}

/// The same for "talk" and "talk/".
std::filesystem::path placeOf(const SlidesOutput& output) {
    const std::filesystem::path place = demos::placeOf(output.name);
    return place.has_filename() ? place : place.parent_path();
}

}  // namespace

std::vector<SlidesOutput> slidesOutputsOf(const Options& options, const Deck& deck) {
    std::vector<std::string> names = options.outputs;
    if (names.empty()) names = {"output/" + deck.name + ".html"};
    std::vector<SlidesOutput> outputs;
    for (const std::string& name : names) {
        const SlidesOutput output = outputOf(name);
        for (const SlidesOutput& other : outputs)
            if (placeOf(other) == placeOf(output))
                refuseOutput(name, "another --output goes there already");
        spareSources(name, deck);
        outputs.push_back(output);
    }
    for (const SlidesOutput& output : outputs)
        if (output.kind == SlidesKind::folder)
            checkSlidesFolder(output.name, options.overwrite);
        else
            checkFree(output.name, options.overwrite);
    return outputs;
}

}  // namespace demos
