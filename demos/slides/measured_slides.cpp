#include <nlohmann/json.hpp>
#include <string_view>

#include "demos/slides/headless.h"
#include "demos/slides/linked_page.h"
#include "demos/slides/measure_script.h"
#include "demos/slides/measured_slide.h"
#include "demos/slides/scratch_folder.h"
#include "demos/text/base64.h"
#include "demos/text/file_content.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

using nlohmann::json;

/// Typefaces that every office program has, or one of the same widths.
constexpr const char* kMeasureStyle =
    "<style>body, .slide { font-family: Arial, \"Liberation Sans\", \"Nimbus Sans\", "
    "\"DejaVu Sans\", sans-serif; } pre, code { font-family: \"Courier New\", \"Liberation "
    "Mono\", \"Nimbus Mono PS\", \"DejaVu Sans Mono\", monospace !important; }</style>\n";

std::string measuringPage(const MadeDeck& deck) {
    std::string page = blankSlidesPage(deck);
    page.insert(page.rfind("</body>"), std::string(kMeasureStyle) + "<script>" + kMeasureScript +
                                           "</script>\n");
    return page;
}

SlideBox boxIn(const json& box) { return {box.at(0), box.at(1), box.at(2), box.at(3)}; }

MeasuredWords wordsIn(const json& words) {
    return {boxIn(words.at("box")), words.at("size"), words.at("line"), words.at("centered")};
}

MeasuredFormula formulaIn(const json& formula) {
    const std::string png = fromBase64(formula.at("png").get_ref<const std::string&>()).value();
    return {boxIn(formula.at("box")), formula.at("tex"), {png.begin(), png.end()}};
}

MeasuredBlock blockIn(const json& block) {
    MeasuredBlock result{wordsIn(block.at("words")), {}};
    if (!block.at("formula").is_null()) result.formula = formulaIn(block.at("formula"));
    return result;
}

MeasuredTable tableIn(const json& table) {
    return {wordsIn(table.at("words")), table.at("columns"), table.at("rows")};
}

template <class T>
std::vector<T> listIn(const json& list, T (*item)(const json&)) {
    std::vector<T> items;
    for (const json& one : list) items.push_back(item(one));
    return items;
}

MeasuredSlide slideIn(const json& slide) {
    MeasuredSlide result;
    result.title = listIn(slide.at("title"), wordsIn);
    result.caption = listIn(slide.at("caption"), wordsIn);
    result.code = listIn(slide.at("code"), wordsIn);
    result.under = listIn(slide.at("under"), wordsIn);
    result.blocks = listIn(slide.at("blocks"), blockIn);
    result.formulas = listIn(slide.at("formulas"), formulaIn);
    result.tables = listIn(slide.at("tables"), tableIn);
    result.pictures = listIn(slide.at("pictures"), boxIn);
    return result;
}

/// The page's JSON in what Chromium printed; empty if it is not there.
std::string measuredJson(const std::vector<std::uint8_t>& printed) {
    constexpr std::string_view kBegin = "<pre id=\"measured\">", kEnd = "</pre>";
    const std::string_view text(reinterpret_cast<const char*>(printed.data()), printed.size());
    std::size_t begin = text.find(kBegin);
    if (begin == text.npos) return {};
    begin += kBegin.size();
    const std::size_t end = text.find(kEnd, begin);
    if (end == text.npos) return {};
    const auto bytes = fromBase64(text.substr(begin, end - begin));
    return bytes ? std::string(bytes->begin(), bytes->end()) : "";
}

}  // namespace

std::vector<MeasuredSlide> measuredSlides(const MadeDeck& deck, const std::string& program) {
    const ScratchFolder folder;
    render::writeFileAtomically(folder.path() / "talk.html", measuringPage(deck));
    std::string trouble = browse(program, "--dump-dom", folder.path());
    if (!trouble.empty()) throw render::Error(withLastWords(trouble, folder.path()));
    try {
        const json slides = json::parse(measuredJson(contentOf(folder.path() / "words")));
        if (slides.size() == deck.slides.size()) return listIn(slides, slideIn);
    } catch (const std::exception&) {  // not its JSON: told below
    }
    throw render::Error("did not say where the parts of the slides are");
}

}  // namespace demos
