#include "demos/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "demos/options_check.h"
#include "demos/scene/complaints.h"
#include "demos/scene/nearest.h"
#include "demos/stop.h"
#include "demos/version.h"

namespace demos {
namespace {

[[noreturn]] void refuse(const std::string& line) { throw Stop(Exit::usage, line); }

void addSceneChoice(CLI::App& app, Options& options, RawOptions& raw) {
    app.add_option("scene", options.scenes, "a built-in scene (impulse list) or a scene file")
        ->type_name("SCENE")
        ->expected(1)
        ->required();
    app.add_option("--set", options.overrides,
                   "a scene value, e.g. world.hz=240 or solver.sweeps=10; may be given again")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--solver", raw.solver,
                   "the same as --set solver.type=NAME; default: the scene's")
        ->type_name("NAME");
}

void addFeedback(CLI::App& app, Options& options) {
    app.add_flag("--quiet", options.quiet, "print errors and asked-for results only; default: off");
    app.add_flag("--json", options.json, "one JSON object a line on standard output; default: off");
}

void addPicture(CLI::App& app, Options& options, RawOptions& raw) {
    app.add_option("-q,--quality", options.quality,
                   "draft 480x270 @15, low 854x480 @30, medium 1280x720 @30, high 1920x1080 @60, "
                   "4k 3840x2160 @60; default: medium")
        ->type_name("NAME");
    app.add_option("--size", raw.size, "pixels, 1..16384 a side; default: the quality's")
        ->type_name("WxH");
    app.add_option("--fps", options.fps,
                   "frames a second; the scene's steps a second must be a multiple; "
                   "default: the quality's")
        ->type_name("N");
    app.add_option("--samples", options.samples,
                   "samples a pixel: 1, 2, 4, 8 or 16; default: the quality's")
        ->type_name("N");
    app.add_option("--show", raw.show,
                   "overlays, with commas: contacts normals impulses friction nudges joints axes "
                   "trails caption stats; default: the scene's")
        ->type_name("NAMES")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_option("--theme", options.theme, "studio, dark or print; default: the scene's")
        ->type_name("NAME");
    app.add_flag("--clean", options.clean, "no text in the picture; default: off");
    app.add_flag("--reproducible", options.reproducible,
                 "the same pixels on every x86-64 processor, a third slower; default: off");
    app.add_flag("--overwrite", options.overwrite,
                 "replace what another run has written; default: off");
}

void addSeconds(CLI::App& app, Options& options) {
    app.add_option("--seconds", options.seconds, "length in s; default: the scene's")
        ->type_name("S");
}

void addRender(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.add_option("-o,--output", options.outputs,
                   "a folder, a pattern (#### {frame:6} {scene} {quality} {time}), a film (.mp4 "
                   ".webm .gif .webp .apng) or - for raw RGBA; may be given again; "
                   "default: output/<scene>")
        ->type_name("OUT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    addSeconds(app, options);
    addPicture(app, options, raw);
    app.add_option("-j,--jobs", options.jobs, "drawing processes; default: 0, one a core")
        ->type_name("N");
    addFeedback(app, options);
}

void addStill(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    CLI::Option* time = app.add_option("-t,--time", options.time, "time in s; default: the end");
    time->type_name("S");
    app.add_option("-f,--frame", options.frame,
                   "number of the frame in the film; negative: from the end; default: the last")
        ->type_name("N")
        ->excludes(time);
    app.add_option(
           "-o,--output", options.outputs,
           "a .png, patterns as for render, or - ; default: output/<scene>/still_<time>.png")
        ->type_name("OUT")
        ->expected(1);
    addSeconds(app, options);
    addPicture(app, options, raw);
    addFeedback(app, options);
}

void addSim(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    addSeconds(app, options);
    const auto table = [&](const char* name, std::string& file, const char* columns) {
        app.add_option(name, file, std::string(columns) + "; default: not written")
            ->type_name("FILE|-");
    };
    table("--csv", options.csv, "a row a step: energies (J), contacts, penetration (m), residual");
    table("--bodies", options.bodies, "a row a step and body: position (m), rotation, velocities");
    table("--joints", options.joints, "a row a step and joint: separation (m), force (N)");
    table("--contacts", options.contacts, "a row a contact point: where, normal, impulse (N s)");
    table("--sweeps", options.sweeps, "a row a sweep: residual (m/s), change (N s)");
    app.add_option("--every", options.every, "rows of every Nth step only; default: 1")
        ->type_name("N");
    app.add_flag("--hash", options.hash, "print the last step's state hash; default: off");
    app.add_option("--hash-every", options.hashEvery, "and every Nth step's; default: 0, off")
        ->type_name("N");
    app.add_flag("--expect,!--no-expect", options.expect,
                 "check the scene's [[expect]]; default: on");
    addFeedback(app, options);
}

void addBench(CLI::App& app, Options& options, RawOptions& raw) {
    addSceneChoice(app, options, raw);
    app.get_option("scene")->expected(0, 1000)->required(false);
    addSeconds(app, options);
    app.add_flag("--render", options.picture, "draw 1280x720 frames as well; default: off");
    addFeedback(app, options);
}

struct CommandText {
    Command command;
    const char* name;
    const char* purpose;
    const char* examples[3];
};
constexpr CommandText kCommands[] = {
    {Command::render,
     "render",
     "simulate and write a film: PNG frames, or a video",
     {"impulse render stack", "impulse render stack -o stack.mp4 -q high",
      "impulse render my.toml -o 'frames/{scene}_####.png' --show contacts,impulses"}},
    {Command::still,
     "still",
     "draw one frame",
     {"impulse still stack -t 2.0", "impulse still stack -f -1 -o last.png -q 4k",
      "impulse still my.toml -t 0.5 --show impulses --theme print"}},
    {Command::sim,
     "sim",
     "physics only: tables, state hash, the scene's expectations",
     {"impulse sim stack", "impulse sim stack --csv energy.csv --bodies bodies.csv --every 4",
      "impulse sim my.toml --set solver.sweeps=4 --hash"}},
    {Command::list,
     "list",
     "the built-in scenes",
     {"impulse list", "impulse list stack", "impulse list stack --print > my.toml"}},
    {Command::doctor,
     "doctor",
     "what this machine can do",
     {"impulse doctor", "impulse doctor --json", "impulse doctor --quiet && impulse render stack"}},
    {Command::bench,
     "bench",
     "time per step, measured over the last 2 s of a scene",
     {"impulse bench", "impulse bench stack chain --json", "impulse bench my.toml --render"}},
    {Command::completion,
     "completion",
     "a completion script for a shell",
     {"impulse completion bash", "source <(impulse completion bash)",
      "impulse completion bash > ~/.local/share/bash-completion/completions/impulse"}},
};

std::string examplesOf(const char* const (&examples)[3], const char* purpose) {
    return fmt::format("Examples:\n  {}\n  {}\n  {}\n\n{}", examples[0], examples[1], examples[2],
                       purpose);
}

void addOptions(Command command, CLI::App& app, Options& options, RawOptions& raw) {
    switch (command) {
        case Command::render:
            return addRender(app, options, raw);
        case Command::still:
            return addStill(app, options, raw);
        case Command::sim:
            return addSim(app, options, raw);
        case Command::bench:
            return addBench(app, options, raw);
        case Command::doctor:
            return addFeedback(app, options);
        case Command::list:
            app.add_option("scene", options.scenes, "a scene to describe; default: all")
                ->type_name("SCENE")
                ->expected(0, 1);
            app.add_flag("--print", options.print, "the scene file itself; default: off");
            app.add_flag("--json", options.json, "one JSON object a line; default: off");
            return;
        case Command::completion:
            app.add_option("shell", options.shell, "bash; default: bash")->type_name("SHELL");
            return;
    }
}

/// The whole command line, bound to `options`.
struct Parser {
    CLI::App app{examplesOf({"impulse render stack -o stack.mp4", "impulse sim chain --csv -",
                             "impulse list"},
                            "impulse: sequential-impulse rigid bodies, filmed without a display"),
                 "impulse"};
    Options options;
    RawOptions raw;

    Parser() {
        app.set_version_flag("--version", std::string("impulse ") + kVersion, "the version");
        app.set_help_flag("-h,--help",
                          "this page; 'impulse COMMAND --help' for a command's options");
        app.require_subcommand(1);
        app.get_formatter()->column_width(26);
        app.footer(
            "SCENE is a name of 'impulse list' or a path to a scene file. Exit codes: 0 ok, "
            "1 expectation failed,\n2 usage, 3 scene file, 4 environment, 5 would overwrite, "
            "6 diverged, 130 interrupted.");
        for (const CommandText& text : kCommands) {
            CLI::App* sub = app.add_subcommand(text.name, text.purpose);
            sub->set_help_flag("-h,--help", "this page");
            sub->callback([this, command = text.command] { options.command = command; });
            addOptions(text.command, *sub, options, raw);
        }
    }
};

std::vector<std::string> namesOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

void checkCommand(int argc, const char* const* argv) {
    std::vector<std::string> names;
    for (const CommandText& text : kCommands) names.emplace_back(text.name);
    if (argc < 2) refuse("no command" + suggestion("", names));
    const std::string word = argv[1];
    if (word.starts_with('-')) return;
    if (std::find(names.begin(), names.end(), word) == names.end())
        refuse(fmt::format("unknown command '{}'{}", printable(word), suggestion(word, names)));
}

/// The first argument that looks like an option and is none.
std::string unknownOption(const CLI::App& app, int argc, const char* const* argv) {
    const std::vector<std::string> names = namesOf(app);
    for (int i = 2; i < argc; ++i) {
        const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
        if (!word.starts_with("--") || word == "--") continue;
        if (std::find(names.begin(), names.end(), word) == names.end())
            return fmt::format("unknown option '{}'{}", printable(word), suggestion(word, names));
    }
    return {};
}

/// What CLI11 says in passing, with what would be right.
std::string lineOf(const CLI::ParseError& error, const std::string& command) {
    std::string text = error.what();
    if (text == "scene is required")
        return fmt::format(
            "{0} needs a scene, as in 'impulse {0} stack'; 'impulse list' names "
            "them",
            command);
    if (text.starts_with("scene: At Most 1")) return command + " takes one scene";
    if (const std::size_t twice = text.find(": At Most 1"); twice != std::string::npos)
        return text.substr(0, twice) + " was given more than once; which is meant?";
    if (dynamic_cast<const CLI::ConversionError*>(&error)) text += "; it must be a number";
    for (char& c : text)
        if (c == '\n') c = ' ';
    return printable(text);
}

/// In single quotes where a shell would take a word apart.
std::string quoted(const std::string& word) {
    const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string commandLineOf(int argc, const char* const* argv) {
    std::string line = "impulse";
    for (int i = 1; i < argc; ++i) line += " " + quoted(argv[i]);
    return printable(line);
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv) {
    checkCommand(argc, argv);
    Parser parser;
    try {
        parser.app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // help, version
        for (const CommandText& text : kCommands)
            if (parser.app.got_subcommand(text.name))
                parser.app.get_subcommand(text.name)->description(
                    examplesOf(text.examples, text.purpose));
        parser.app.exit(asked);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        const auto subs = parser.app.get_subcommands();
        const CLI::App& app = subs.empty() ? parser.app : *subs.front();
        const std::string unknown = unknownOption(app, argc, argv);
        refuse(unknown.empty() ? lineOf(error, app.get_name()) : unknown);
    }
    checkOptions(parser.options, parser.raw);
    parser.options.commandLine = commandLineOf(argc, argv);
    return parser.options;
}

std::vector<CommandWords> commandWords() {
    const Parser parser;
    std::vector<CommandWords> words;
    for (const CommandText& text : kCommands)
        words.push_back({text.name, namesOf(*parser.app.get_subcommand(text.name))});
    return words;
}

}  // namespace demos
