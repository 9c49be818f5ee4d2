#include "demos/site/document_html.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "demos/formulas/formula.h"
#include "demos/formulas/text_formulas.h"
#include "demos/site/markdown_tables.h"
#include "demos/slides/markup.h"
#include "demos/slides/markup_tree.h"

namespace demos {
namespace {

std::string wordsOf(cmark_node* node) {
    switch (cmark_node_get_type(node)) {
        case CMARK_NODE_TEXT:
        case CMARK_NODE_CODE:
        case CMARK_NODE_CODE_BLOCK:
            return cmark_node_get_literal(node);
        case CMARK_NODE_SOFTBREAK:
        case CMARK_NODE_LINEBREAK:
        case CMARK_NODE_PARAGRAPH:
        case CMARK_NODE_ITEM:
            return " ";
        default:
            return "";
    }
}

/// Without line ends and double spaces.
std::string onOneLine(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool space = c == ' ' || c == '\n';
        if (!space) line += c;
        if (space && !line.empty() && line.back() != ' ') line += ' ';
    }
    while (line.ends_with(' ')) line.pop_back();
    return line;
}

std::string wordsIn(cmark_node* root) {
    std::string words;
    for (cmark_node* node : nodesOf(root)) words += wordsOf(node);
    return onOneLine(words);
}

// While cmark reads, a formula is its number between private letters.
constexpr std::string_view kFormula = "\xee\x80\x80", kFormulaEnd = "\xee\x80\x81";

/// Takes the formulas out of a text, and puts them into what was made of it.
class Formulas {
public:
    std::string taken(const std::string& text) {
        std::string result;
        std::size_t done = 0;
        for (const TextFormula& formula : formulasOf(text)) {
            result += text.substr(done, formula.begin - done);
            result += fmt::format("{}{}{}", kFormula, formulas_.size(), kFormulaEnd);
            formulas_.push_back(formula);
            done = formula.end;
        }
        return result + text.substr(done);
    }

    /// `show`: a formula's text in the result.
    std::string put(const std::string& text, const FormulaText& show) const {
        std::string result;
        std::size_t done = 0;
        for (std::size_t at = 0; (at = text.find(kFormula, done)) != std::string::npos;) {
            const std::size_t end = text.find(kFormulaEnd, at);
            const std::size_t first = at + kFormula.size();
            result += text.substr(done, at - done);
            result += show(formulas_.at(std::stoul(text.substr(first, end - first))));
            done = end + kFormulaEnd.size();
        }
        return result + text.substr(done);
    }

private:
    static std::vector<TextFormula> formulasOf(const std::string& text) {
        return text.find('$') == std::string::npos ? std::vector<TextFormula>()
                                                   : scannedText(text).formulas;
    }

    std::vector<TextFormula> formulas_;
};

/// Its LaTeX if a browser cannot draw it.
std::string formulaHtml(const TextFormula& formula) try {
    return mathMlIn(formula);
} catch (const FormulaError&) {
    return "<code>" + htmlEscaped(formula.tex) + "</code>";
}

MarkupTree parsedMarkdown(std::string_view text) {
    MarkupTree tree(cmark_parse_document(text.data(), text.size(), CMARK_OPT_SMART));
    cmark_consolidate_text_nodes(tree.get());
    return tree;
}

std::string renderedHtml(cmark_node* root) {
    const std::unique_ptr<char, decltype(&std::free)> html(
        cmark_render_html(root, CMARK_OPT_DEFAULT), std::free);
    return html.get();
}

bool isIn(cmark_node_type type, cmark_node* node) {
    for (; node; node = cmark_node_parent(node))
        if (cmark_node_get_type(node) == type) return true;
    return false;
}

cmark_node* rawHtml(const std::string& html) {
    cmark_node* node = cmark_node_new(CMARK_NODE_CUSTOM_INLINE);
    cmark_node_set_on_enter(node, html.c_str());
    return node;
}

/// Turns a Markdown text into HTML, piece by piece.
class DocumentWriter {
public:
    explicit DocumentWriter(const DocumentLinks& links) : links_(links) {}

    void add(const MarkdownPiece& piece) {
        if (piece.table)
            addTable(markdownTable(piece.text));
        else
            addBlocks(piece.text);
    }
    DocumentHtml take() { return std::move(made_); }

private:
    void addBlocks(const std::string& text) {
        const MarkupTree tree = parsedMarkdown(formulas_.taken(text));
        std::vector<std::string> headings;  // their opening tags, in order
        for (cmark_node* node = cmark_node_first_child(tree.get()); node;
             node = cmark_node_next(node)) {
            if (cmark_node_get_type(node) == CMARK_NODE_HEADING)
                headings.push_back(begin(cmark_node_get_heading_level(node), wordsIn(node)));
            else
                tell(wordsIn(node));
        }
        dress(tree.get());
        std::string html = renderedHtml(tree.get());
        std::size_t at = 0;
        for (const std::string& tag : headings) {
            at = html.find(tag.substr(0, 3) + ">", at);  // "<h2>" cannot be text
            html.replace(at, 4, tag);
        }
        made_.html += formulas_.put(html, formulaHtml);
    }

    /// Begins a section; the opening tag of its heading.
    std::string begin(int level, const std::string& title) {
        std::string id = headingId(title);
        const auto taken = [this](const std::string& name) {
            for (const DocumentSection& section : made_.sections)
                if (section.id == name) return true;
            return false;
        };
        if (taken(id)) {
            int count = 1;
            while (taken(fmt::format("{}-{}", id, count))) ++count;
            id += fmt::format("-{}", count);
        }
        made_.sections.push_back({level, id, title, ""});
        return fmt::format("<h{} id=\"{}\">", level, htmlEscaped(id));
    }

    void tell(const std::string& words) {
        if (words.empty()) return;
        if (made_.sections.empty()) made_.sections.emplace_back();
        std::string& text = made_.sections.back().text;
        text += (text.empty() ? "" : " ") +
                formulas_.put(words, [](const TextFormula& formula) { return formula.tex; });
    }

    void addTable(const MarkdownTable& table) {
        made_.html += "<div class=\"table\"><table>\n<thead>" + row(table, table.head, "th") +
                      "</thead>\n<tbody>\n";
        for (const std::vector<std::string>& cells : table.rows)
            made_.html += row(table, cells, "td") + "\n";
        made_.html += "</tbody></table></div>\n";
    }

    std::string row(const MarkdownTable& table, const std::vector<std::string>& cells,
                    const char* tag) {
        std::string html = "<tr>";
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const bool right = i < table.right.size() && table.right[i];
            html += fmt::format("<{}{}>{}</{}>", tag, right ? " class=\"number\"" : "",
                                cell(cells[i]), tag);
        }
        return html + "</tr>";
    }

    /// A cell is one paragraph.
    std::string cell(const std::string& text) {
        constexpr std::size_t kOpen = 3, kClose = 5;  // "<p>", "</p>\n"
        const MarkupTree tree = parsedMarkdown(formulas_.taken(text));
        tell(wordsIn(tree.get()));
        dress(tree.get());
        const std::string html = renderedHtml(tree.get());
        const bool paragraph = html.starts_with("<p>") && html.ends_with("</p>\n");
        return paragraph
                   ? formulas_.put(html.substr(kOpen, html.size() - kOpen - kClose), formulaHtml)
                   : htmlEscaped(text);
    }

    void dress(cmark_node* root) const {
        for (cmark_node* node : nodesOf(root)) switch (cmark_node_get_type(node)) {
                case CMARK_NODE_LINK:
                    dressLink(node);
                    break;
                case CMARK_NODE_CODE:
                    dressCode(node);
                    break;
                default:
                    break;
            }
        for (cmark_node* node : nodesOf(root))
            if (cmark_node_get_type(node) == CMARK_NODE_IMAGE) return dressPicture(node, root);
    }

    void dressLink(cmark_node* node) const {
        const std::string target = links_.link(cmark_node_get_url(node));
        if (target.empty())
            unwrapNode(node);
        else
            cmark_node_set_url(node, target.c_str());
    }

    void dressCode(cmark_node* node) const {
        if (isIn(CMARK_NODE_LINK, node) || isIn(CMARK_NODE_HEADING, node)) return;
        const std::string code = cmark_node_get_literal(node), target = links_.code(code);
        if (target.empty()) return;
        replaceNode(node, rawHtml(fmt::format("<a href=\"{}\"><code>{}</code></a>",
                                              htmlEscaped(target), htmlEscaped(code))));
    }

    /// Pictures one by one: unwrapping changes the tree.
    void dressPicture(cmark_node* node, cmark_node* root) const {
        const std::string target = links_.picture(cmark_node_get_url(node));
        const std::string html = target.empty()
                                     ? ""
                                     : fmt::format("<img src=\"{}\" alt=\"{}\" loading=\"lazy\">",
                                                   htmlEscaped(target), htmlEscaped(wordsIn(node)));
        replaceNode(node, rawHtml(html));
        dress(root);
    }

    const DocumentLinks& links_;
    Formulas formulas_;
    DocumentHtml made_;
};

}  // namespace

std::string headingId(const std::string& title) {
    std::string id;
    for (const char c : title) {
        const bool upper = c >= 'A' && c <= 'Z', digit = c >= '0' && c <= '9';
        const bool other = c == '-' || c == '_' || static_cast<unsigned char>(c) >= 0x80;
        if (upper) id += static_cast<char>(c - 'A' + 'a');
        if ((c >= 'a' && c <= 'z') || digit || other) id += c;
        if (c == ' ') id += '-';
    }
    return id;
}

DocumentHtml documentHtml(std::string_view markdown, const DocumentLinks& links) {
    DocumentWriter writer(links);
    for (const MarkdownPiece& piece : markdownPieces(markdown)) writer.add(piece);
    return writer.take();
}

}  // namespace demos
