#include "demos/slides/beamer_preamble.h"

#include <fmt/format.h>

#include <map>
#include <string_view>

#include "demos/formulas/math_letters.h"

namespace demos {
namespace {

constexpr const char* kPackages =
    R"tex(% Made by impulse slides. To typeset it, run pdflatex talk.tex twice. A letter that pdfLaTeX
% lacks becomes a ?; lualatex has the letters of its font.
\documentclass[aspectratio=169]{beamer}
\usepackage{iftex}
\ifPDFTeX
  \usepackage[T1]{fontenc}
  \usepackage[utf8]{inputenc}
  \usepackage{lmodern}
\fi
\usepackage{amsmath,amssymb,mathtools,amscd,bm,booktabs,graphicx}
\setbeamertemplate{navigation symbols}{}
\setbeamertemplate{footline}[frame number]
\setbeamercolor{structure}{fg=blue!45!black}
\newsavebox{\fitbox}
\newcommand{\fit}[1]{\sbox{\fitbox}{#1}%
  \ifdim\wd\fitbox>\linewidth\resizebox{\linewidth}{!}{\usebox{\fitbox}}\else\usebox{\fitbox}\fi}
% For two screens: \setbeameroption{show notes on second screen=right}
)tex";

/// A command that KaTeX has in addition to LaTeX; without arguments.
struct Word {
    const char* name;
    const char* meaning;
};

constexpr Word kWords[] = {
    {"N", "\\mathbb{N}"},
    {"R", "\\mathbb{R}"},
    {"Z", "\\mathbb{Z}"},
    {"natnums", "\\mathbb{N}"},
    {"reals", "\\mathbb{R}"},
    {"Reals", "\\mathbb{R}"},
    {"cnums", "\\mathbb{C}"},
    {"Complex", "\\mathbb{C}"},
    {"Alpha", "\\mathrm{A}"},
    {"Beta", "\\mathrm{B}"},
    {"Epsilon", "\\mathrm{E}"},
    {"Zeta", "\\mathrm{Z}"},
    {"Eta", "\\mathrm{H}"},
    {"Iota", "\\mathrm{I}"},
    {"Kappa", "\\mathrm{K}"},
    {"Mu", "\\mathrm{M}"},
    {"Nu", "\\mathrm{N}"},
    {"Omicron", "\\mathrm{O}"},
    {"Rho", "\\mathrm{P}"},
    {"Tau", "\\mathrm{T}"},
    {"Chi", "\\mathrm{X}"},
    {"omicron", "o"},
    {"thetasym", "\\vartheta"},
    {"alef", "\\aleph"},
    {"alefsym", "\\aleph"},
    {"weierp", "\\wp"},
    {"image", "\\Im"},
    {"infin", "\\infty"},
    {"exist", "\\exists"},
    {"isin", "\\in"},
    {"notni", "\\not\\ni"},
    {"plusmn", "\\pm"},
    {"sdot", "\\cdot"},
    {"degree", "^\\circ"},
    {"lt", "<"},
    {"gt", ">"},
    {"sub", "\\subset"},
    {"sube", "\\subseteq"},
    {"supe", "\\supseteq"},
    {"bull", "\\bullet"},
    {"clubs", "\\clubsuit"},
    {"diamonds", "\\diamondsuit"},
    {"hearts", "\\heartsuit"},
    {"spades", "\\spadesuit"},
    {"Dagger", "\\ddagger"},
    {"sect", "\\S"},
    {"lang", "\\langle"},
    {"rang", "\\rangle"},
    {"llbracket", "[\\mkern-2mu["},
    {"rrbracket", "]\\mkern-2mu]"},
    {"lBrace", "\\{\\mkern-3mu|"},
    {"rBrace", "|\\mkern-3mu\\}"},
    {"larr", "\\leftarrow"},
    {"rarr", "\\rightarrow"},
    {"harr", "\\leftrightarrow"},
    {"lrarr", "\\leftrightarrow"},
    {"uarr", "\\uparrow"},
    {"darr", "\\downarrow"},
    {"varr", "\\updownarrow"},
    {"lArr", "\\Leftarrow"},
    {"rArr", "\\Rightarrow"},
    {"hArr", "\\Leftrightarrow"},
    {"lrArr", "\\Leftrightarrow"},
    {"uArr", "\\Uparrow"},
    {"dArr", "\\Downarrow"},
    {"Larr", "\\Leftarrow"},
    {"Rarr", "\\Rightarrow"},
    {"Harr", "\\Leftrightarrow"},
    {"Lrarr", "\\Leftrightarrow"},
    {"Uarr", "\\Uparrow"},
    {"Darr", "\\Downarrow"},
    {"coloncolon", "\\dblcolon"},
    {"colonequals", "\\coloneqq"},
    {"coloncolonequals", "\\Coloneqq"},
    {"equalscolon", "\\eqqcolon"},
    {"equalscoloncolon", "\\Eqqcolon"},
    {"colonminus", "\\mathrel{\\vcentcolon-}"},
    {"minuscolon", "\\mathrel{-\\vcentcolon}"},
    {"approxcoloncolon", "\\approx\\dblcolon"},
    {"coloncolonapprox", "\\Colonapprox"},
    {"coloncolonsim", "\\Colonsim"},
    {"simcoloncolon", "\\sim\\dblcolon"},
    {"hdashline", "\\hline"},
    {"mathscr", "\\mathcal"},
    {"ratio", "\\vcentcolon"},
};

constexpr const char* kOperators[] = {"arcctg", "arctg", "ch", "cosec", "cotg",
                                      "ctg",    "cth",   "sh", "tg"};

constexpr const char* kOthers = R"tex(\providecommand{\argmax}{\operatorname*{arg\,max}}
\providecommand{\argmin}{\operatorname*{arg\,min}}
\providecommand{\plim}{\operatorname*{plim}}
\providecommand{\bra}[1]{\langle#1|}
\providecommand{\ket}[1]{|#1\rangle}
\providecommand{\braket}[1]{\langle#1\rangle}
\providecommand{\Bra}[1]{\left\langle#1\right|}
\providecommand{\Ket}[1]{\left|#1\right\rangle}
\providecommand{\Braket}[1]{\left\langle#1\right\rangle}
\providecommand{\set}[1]{\{\,#1\,\}}
\providecommand{\Set}[1]{\left\{\,#1\,\right\}}
\providecommand{\xlongequal}[2][]{\overset{#2}{\underset{#1}{=\joinrel=}}}
\providecommand{\xtofrom}[2][]{\xrightleftharpoons[#1]{#2}}
\providecommand{\xrightequilibrium}[2][]{\xrightleftharpoons[#1]{#2}}
\providecommand{\xleftequilibrium}[2][]{\xleftrightharpoons[#1]{#2}}
)tex";

/// Letters that pdfLaTeX does not declare, or declares only for text.
const std::map<char32_t, const char*> kLetters = {{0xb0, "^\\circ"},
                                                  {0xb1, "\\pm"},
                                                  {0xb2, "^2"},
                                                  {0xb3, "^3"},
                                                  {0xb5, "\\mu"},
                                                  {0xb7, "\\cdot"},
                                                  {0xb9, "^1"},
                                                  {0xd7, "\\times"},
                                                  {0xf7, "\\div"},
                                                  {0x393, "\\Gamma"},
                                                  {0x394, "\\Delta"},
                                                  {0x398, "\\Theta"},
                                                  {0x39b, "\\Lambda"},
                                                  {0x39e, "\\Xi"},
                                                  {0x3a0, "\\Pi"},
                                                  {0x3a3, "\\Sigma"},
                                                  {0x3a5, "\\Upsilon"},
                                                  {0x3a6, "\\Phi"},
                                                  {0x3a8, "\\Psi"},
                                                  {0x3a9, "\\Omega"},
                                                  {0x3b1, "\\alpha"},
                                                  {0x3b2, "\\beta"},
                                                  {0x3b3, "\\gamma"},
                                                  {0x3b4, "\\delta"},
                                                  {0x3b5, "\\varepsilon"},
                                                  {0x3b6, "\\zeta"},
                                                  {0x3b7, "\\eta"},
                                                  {0x3b8, "\\theta"},
                                                  {0x3b9, "\\iota"},
                                                  {0x3ba, "\\kappa"},
                                                  {0x3bb, "\\lambda"},
                                                  {0x3bc, "\\mu"},
                                                  {0x3bd, "\\nu"},
                                                  {0x3be, "\\xi"},
                                                  {0x3bf, "o"},
                                                  {0x3c0, "\\pi"},
                                                  {0x3c1, "\\rho"},
                                                  {0x3c2, "\\varsigma"},
                                                  {0x3c3, "\\sigma"},
                                                  {0x3c4, "\\tau"},
                                                  {0x3c5, "\\upsilon"},
                                                  {0x3c6, "\\varphi"},
                                                  {0x3c7, "\\chi"},
                                                  {0x3c8, "\\psi"},
                                                  {0x3c9, "\\omega"},
                                                  {0x3d1, "\\vartheta"},
                                                  {0x3d5, "\\phi"},
                                                  {0x3f5, "\\epsilon"},
                                                  {0x2032, "'"},
                                                  {0x2070, "^0"},
                                                  {0x2074, "^4"},
                                                  {0x2075, "^5"},
                                                  {0x2076, "^6"},
                                                  {0x2077, "^7"},
                                                  {0x2078, "^8"},
                                                  {0x2079, "^9"},
                                                  {0x207b, "^-"},
                                                  {0x2190, "\\leftarrow"},
                                                  {0x2191, "\\uparrow"},
                                                  {0x2192, "\\rightarrow"},
                                                  {0x2193, "\\downarrow"},
                                                  {0x2194, "\\leftrightarrow"},
                                                  {0x21d0, "\\Leftarrow"},
                                                  {0x21d2, "\\Rightarrow"},
                                                  {0x21d4, "\\Leftrightarrow"},
                                                  {0x2200, "\\forall"},
                                                  {0x2202, "\\partial"},
                                                  {0x2203, "\\exists"},
                                                  {0x2207, "\\nabla"},
                                                  {0x2208, "\\in"},
                                                  {0x2211, "\\sum"},
                                                  {0x2212, "-"},
                                                  {0x221a, "\\surd"},
                                                  {0x221e, "\\infty"},
                                                  {0x222b, "\\int"},
                                                  {0x2248, "\\approx"},
                                                  {0x2260, "\\neq"},
                                                  {0x2264, "\\leq"},
                                                  {0x2265, "\\geq"},
                                                  {0x22a5, "\\perp"},
                                                  {0x22c5, "\\cdot"},
                                                  {0x27e8, "\\langle"},
                                                  {0x27e9, "\\rangle"}};

/// Whether a letter has no width of its own: joiners, combining marks, variation selectors.
bool isUnseen(char32_t letter) {
    return (letter >= 0x300 && letter <= 0x36f) || (letter >= 0x200b && letter <= 0x200f) ||
           (letter >= 0x2060 && letter <= 0x2064) || (letter >= 0xfe00 && letter <= 0xfe0f) ||
           letter == 0xfeff;
}

std::string declarationOf(char32_t letter, std::string_view utf8) {
    const auto code = static_cast<unsigned>(letter);
    if (const auto known = kLetters.find(letter); known != kLetters.end())
        return fmt::format("  \\DeclareUnicodeCharacter{{{:04X}}}{{\\ensuremath{{{}}}}}\n", code,
                           known->second);
    return fmt::format("  \\otherletter{{{:04X}}}{{{}}}{{{}}}\n", code, utf8,
                       isUnseen(letter) ? "" : "?");
}

/// Declarations of the letters in `body`, each once. \otherletter skips letters of T1's fonts.
std::string declarationsFor(std::string_view body) {
    std::map<char32_t, std::string> declarations;
    while (!body.empty()) {
        const std::string_view before = body;
        const char32_t letter = popCharacter(body);
        if (letter >= 0x80)
            declarations.try_emplace(
                letter, declarationOf(letter, before.substr(0, before.size() - body.size())));
    }
    if (declarations.empty()) return {};
    std::string latex =
        "\\ifPDFTeX\n"
        "  \\newcommand{\\otherletter}[3]{\\ifcsname u8:\\detokenize{#2}\\endcsname\\else\n"
        "    \\DeclareUnicodeCharacter{#1}{#3}\\fi}\n";
    for (const auto& [letter, text] : declarations) latex += text;
    return latex + "\\fi\n";
}

bool uses(const std::string& latex, const std::string& name) {
    const std::string command = "\\" + name;
    for (std::size_t at = 0; (at = latex.find(command, at)) != std::string::npos; ++at) {
        const char next = latex[at + command.size()];  // at the string's end it is a NUL
        const bool letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
        if (!letter) return true;
    }
    return false;
}

/// Only the commands that `body` uses.
std::string wordsFor(const std::string& body) {
    std::string latex;
    for (const Word& word : kWords)
        if (uses(body, word.name))
            latex += fmt::format("\\providecommand{{\\{}}}{{{}}}\n", word.name, word.meaning);
    for (const char* name : kOperators)
        if (uses(body, name))
            latex += fmt::format("\\providecommand{{\\{0}}}{{\\operatorname{{{0}}}}}\n", name);
    return latex;
}

}  // namespace

std::string beamerPreamble(const std::string& body) {
    return kPackages + std::string(kOthers) + wordsFor(body) + declarationsFor(body);
}

}  // namespace demos
