#include "demos/program/parse.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "demos/program/command_table.h"
#include "demos/program/licenses.h"
#include "demos/text/complaints.h"
#include "demos/text/nearest.h"
#include "demos/text/shell_word.h"
#include "demos/text/stop.h"
#include "demos/text/version.h"

namespace demos {
namespace {

std::string examplesOf(const char* const (&examples)[3], const char* purpose) {
    return fmt::format("Examples:\n  {}\n  {}\n  {}\n\n{}", examples[0], examples[1], examples[2],
                       purpose);
}

/// The whole command line. `run` is the chosen command, called after parsing.
struct Parser {
    CLI::App app{examplesOf({"impulse render stack -o stack.mp4", "impulse sim chain --csv -",
                             "impulse list"},
                            (std::string("impulse: ") + kProgramPurpose).c_str()),
                 "impulse"};
    Run run;

    Parser() {
        app.set_version_flag("--version", std::string("impulse ") + kVersion, "the version");
        app.add_flag_callback(
            "--licenses", [] { throw CLI::CallForVersion(std::string(licenses()), 0); },
            "the notices of what is built in");
        app.set_help_flag("-h,--help",
                          "this page; 'impulse COMMAND --help' for a command's options");
        app.require_subcommand(1);
        app.get_formatter()->column_width(26);
        app.footer(closingWords());
        for (const Command& command : commandTable()) {
            CLI::App* sub = app.add_subcommand(command.name, command.purpose);
            sub->set_help_flag("-h,--help", "this page");
            sub->callback([this, asked = command.add(*sub)] { run = asked; });
        }
    }
};

std::vector<std::string> namesOf(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> namesOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : namesOf(*option)) names.push_back(name);
    return names;
}

OptionWords wordsOf(const CLI::Option& option) {
    const bool takesNone = option.get_items_expected_max() == 0;
    return {namesOf(option), takesNone ? "" : option.get_type_name(), option.get_description()};
}

void checkCommand(int argc, const char* const* argv) {
    std::vector<std::string> names;
    for (const Command& command : commandTable()) names.emplace_back(command.name);
    if (argc < 2) refuse("no command" + suggestion("", names));
    const std::string word = argv[1];
    if (word.starts_with('-')) return;
    if (std::find(names.begin(), names.end(), word) == names.end())
        refuse(fmt::format("unknown command '{}'{}", printable(word), suggestion(word, names)));
}

/// "--fps" of "--fps=10", "-q" of "-qdraft"; empty: no option, but a value such as -1 or -.
std::string optionOf(const std::string& word) {
    if (word.starts_with("--")) return word == "--" ? "" : word.substr(0, word.find('='));
    const bool letter =
        word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1]));
    return letter ? word.substr(0, 2) : "";
}

/// Reports the first argument that looks like an option but is none.
std::string unknownOption(const CLI::App& app, int argc, const char* const* argv) {
    const std::vector<std::string> names = namesOf(app);
    for (int i = 2; i < argc; ++i) {
        const std::string word = optionOf(argv[i]);
        if (word.empty() || std::find(names.begin(), names.end(), word) != names.end()) continue;
        if (word.starts_with("--"))
            return fmt::format("unknown option '{}'{}", printable(word), suggestion(word, names));
        return fmt::format("{0}: {1} has no such option; 'impulse {1} --help' lists its options",
                           printable(word), app.get_name());
    }
    return {};
}

/// Refuses empty values: they would count as an option that was not given, which nobody intends.
void checkValues(int argc, const char* const* argv) {
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i], before = argv[i - 1];
        if (word.empty())
            refuse(fmt::format("'{}' is followed by an empty word; give it a value or leave it out",
                               printable(before)));
        if (word.starts_with("--") && word.ends_with('='))
            refuse(fmt::format("'{}' has no value; give it one or leave it out", printable(word)));
    }
}

/// Rewords CLI11's "Could not convert: --fps = 29.97".
std::string conversionLine(const CLI::App& app, const std::string& text) {
    const std::size_t name = text.find("--"), equals = text.find(" = ");
    if (name == std::string::npos || equals == std::string::npos || equals < name) return text;
    const std::string option = text.substr(name, equals - name);
    const CLI::Option* known = app.get_option_no_throw(option);
    const bool seconds = known && known->get_type_name() == "S";
    return fmt::format("{} {}: must be a {}", option, text.substr(equals + 3),
                       seconds ? "number of seconds" : "whole number of at most nine digits");
}

/// Rewords CLI11's messages and adds what would be valid.
std::string lineOf(const CLI::ParseError& error, const CLI::App& app) {
    const std::string command = app.get_name();
    std::string text = error.what();
    if (text == "scene is required")
        return fmt::format(
            "{0} needs a scene, as in 'impulse {0} stack'; 'impulse list' lists "
            "them",
            command);
    if (text.starts_with("scene: At Most 1")) return command + " takes one scene";
    if (const std::size_t twice = text.find(": At Most 1"); twice != std::string::npos)
        return text.substr(0, twice) + " was given more than once; give it once";
    if (const std::size_t none = text.find(": 1 required "); none != std::string::npos)
        return fmt::format("{} needs a value; see impulse {} --help", text.substr(0, none),
                           command);
    if (dynamic_cast<const CLI::ConversionError*>(&error)) text = conversionLine(app, text);
    for (char& c : text)
        if (c == '\n') c = ' ';
    return printable(text);
}

std::string commandLineOf(int argc, const char* const* argv) {
    std::string line = "impulse";
    for (int i = 1; i < argc; ++i) line += " " + shellWord(argv[i]);
    return printable(line);
}

}  // namespace

std::optional<std::function<Exit()>> parse(int argc, const char* const* argv) {
    checkCommand(argc, argv);
    checkValues(argc, argv);
    Parser parser;
    try {
        parser.app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // help, version
        for (const Command& command : commandTable())
            if (parser.app.got_subcommand(command.name))
                parser.app.get_subcommand(command.name)
                    ->description(examplesOf(command.examples, command.purpose));
        parser.app.exit(asked);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        const auto subs = parser.app.get_subcommands();
        const CLI::App& app = subs.empty() ? parser.app : *subs.front();
        const std::string unknown = unknownOption(app, argc, argv);
        refuse(unknown.empty() ? lineOf(error, app) : unknown);
    }
    return [run = parser.run, line = commandLineOf(argc, argv)] { return run(line); };
}

std::vector<CommandWords> commandWords() {
    const Parser parser;
    std::vector<CommandWords> all;
    for (const Command& command : commandTable()) {
        CommandWords words{command.name, command.purpose, {}, {}};
        for (const char* example : command.examples) words.examples.emplace_back(example);
        for (const CLI::Option* option : parser.app.get_subcommand(command.name)->get_options())
            words.options.push_back(wordsOf(*option));
        all.push_back(std::move(words));
    }
    return all;
}

std::vector<OptionWords> programOptions() {
    const Parser parser;
    std::vector<OptionWords> all;
    for (const CLI::Option* option : parser.app.get_options()) all.push_back(wordsOf(*option));
    return all;
}

std::string closingWords() {
    return "SCENE is a name of 'impulse list' or a path to a scene file. Exit codes: 0 ok, "
           "1 expectation or snapshot failed,\n2 usage, 3 scene file, 4 environment, 5 would "
           "overwrite, 6 incident, 7 parts are missing, 130 interrupted.";
}

}  // namespace demos
