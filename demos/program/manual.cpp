#include "demos/program/manual.h"

#include <fmt/format.h>

#include "demos/program/parse.h"
#include "demos/text/version.h"

namespace demos {
namespace {

/// Text for roff: hyphens of options are not typographic ones, and no line begins with a request.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (out.empty() || out.back() == '\n')
            if (c == '.' || c == '\'') out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

std::string optionHead(const OptionWords& option) {
    std::string head;
    for (const std::string& name : option.names)
        head += (head.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
    if (!option.value.empty())
        head += (head.empty() ? "\\fI" : " \\fI") + roff(option.value) + "\\fR";
    return head;
}

std::string optionPart(const OptionWords& option) {
    return ".TP\n" + optionHead(option) + "\n" + roff(option.text) + "\n";
}

std::string commandPart(const CommandWords& command) {
    std::string text = ".SS " + roff(command.name) + "\n" + roff(command.purpose) + "\n.PP\n.nf\n";
    for (const std::string& example : command.examples) text += roff(example) + "\n";
    text += ".fi\n";
    for (const OptionWords& option : command.options) text += optionPart(option);
    return text;
}

Exit manual() {
    fmt::print(".TH IMPULSE 1 \"\" \"impulse {}\" \"User Commands\"\n", kVersion);
    fmt::print(".SH NAME\nimpulse \\- {}\n", roff(kProgramPurpose));
    fmt::print(".SH SYNOPSIS\n\\fBimpulse\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...]\n");
    fmt::print(".SH DESCRIPTION\n{}\n.SH OPTIONS\n", roff(closingWords()));
    for (const OptionWords& option : programOptions()) fmt::print("{}", optionPart(option));
    fmt::print(".SH COMMANDS\n");
    for (const CommandWords& command : commandWords()) fmt::print("{}", commandPart(command));
    return Exit::ok;
}

}  // namespace

Command manCommand() {
    return {"man",
            "the manual page, for man",
            {"impulse man | man -l -", "impulse man > impulse.1",
             "impulse man > ~/.local/share/man/man1/impulse.1"},
            [](CLI::App&) -> Run { return [](const std::string&) { return manual(); }; }};
}

}  // namespace demos
