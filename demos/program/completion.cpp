#include "demos/program/completion.h"

#include <fmt/format.h>

#include "demos/commands/shared_options.h"
#include "demos/load/builtin.h"
#include "demos/program/parse.h"

namespace demos {
namespace {

std::string sceneWords() {
    std::string scenes;
    for (const BuiltinScene& scene : builtinScenes())
        scenes += (scenes.empty() ? "" : " ") + std::string(scene.name);
    return scenes;
}

/// What an option does, in a few words: up to its first semicolon.
std::string hintOf(const OptionWords& option) {
    return option.text.substr(0, option.text.find(';'));
}

/// With a backslash before each of these characters.
std::string escaped(const std::string& text, const char* characters) {
    std::string out;
    for (const char c : text) {
        if (std::string_view(characters).find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

void completeBash() {
    std::string names, cases;
    for (const CommandWords& command : commandWords()) {
        names += (names.empty() ? "" : " ") + command.name;
        std::string words;
        for (const OptionWords& option : command.options)
            for (const std::string& name : option.names) words += (words.empty() ? "" : " ") + name;
        cases += fmt::format("        {}) words=\"{}\" ;;\n", command.name, words);
    }
    fmt::print(R"(# bash completion for impulse; load it with: source <(impulse completion bash)
_impulse() {{
    local word="${{COMP_WORDS[COMP_CWORD]}}" words=""
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "{} --help --version --licenses" -- "$word"))
        return
    fi
    case "${{COMP_WORDS[1]}}" in
{}    esac
    [[ "$word" == -* ]] || words="{}"
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _impulse impulse
)",
               names, cases, sceneWords());
}

/// 'name:hint', as _describe takes it.
std::string described(const std::string& name, const std::string& hint) {
    std::string quoted;
    for (const char c : escaped(name, ":\\") + ":" + escaped(hint, "\\"))
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return " '" + quoted + "'";
}

void completeZsh() {
    std::string commands, cases;
    for (const CommandWords& command : commandWords()) {
        commands += described(command.name, command.purpose);
        std::string options;
        for (const OptionWords& option : command.options)
            for (const std::string& name : option.names) options += described(name, hintOf(option));
        cases += fmt::format("        {}) options=({} ) ;;\n", command.name, options);
    }
    fmt::print(R"(#compdef impulse
# zsh completion for impulse; load it with: source <(impulse completion zsh)
_impulse() {{
    local -a commands options scenes
    commands=({} )
    if (( CURRENT == 2 )); then
        _describe command commands
        return
    fi
    case "$words[2]" in
{}    esac
    scenes=({})
    if [[ "$PREFIX" == -* ]]; then
        _describe -o option options
    else
        compadd -a scenes
        _files
    fi
}}
if [[ "$funcstack[1]" == _impulse ]]; then _impulse "$@"; else compdef _impulse impulse; fi
)",
               commands, cases, sceneWords());
}

std::string fishText(const std::string& text) { return "'" + escaped(text, "'\\") + "'"; }

void completeFish() {
    fmt::print("# fish completion for impulse; load it with: impulse completion fish | source\n");
    for (const CommandWords& command : commandWords()) {
        fmt::print("complete -c impulse -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                   fishText(command.purpose));
        for (const OptionWords& option : command.options) {
            if (option.names.empty()) continue;
            std::string names;
            for (const std::string& name : option.names)
                names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            fmt::print("complete -c impulse -n '__fish_seen_subcommand_from {}'{}{} -d {}\n",
                       command.name, names, option.value.empty() ? "" : " -r",
                       fishText(hintOf(option)));
        }
    }
    fmt::print("complete -c impulse -n 'not __fish_use_subcommand' -a {}\n",
               fishText(sceneWords()));
}

struct Shell {
    const char* name;
    void (*complete)();
};
constexpr Shell kShells[] = {{"bash", completeBash}, {"zsh", completeZsh}, {"fish", completeFish}};

Run addCompletion(CLI::App& app) {
    const auto asked = std::make_shared<std::string>("bash");
    app.add_option("shell", *asked, "bash, zsh or fish; default: bash")->type_name("SHELL");
    return [asked](const std::string&) {
        checkName("shell", *asked, {"bash", "zsh", "fish"});
        for (const Shell& shell : kShells)
            if (*asked == shell.name) shell.complete();
        return Exit::ok;
    };
}

}  // namespace

Command completionCommand() {
    return {"completion",
            "a completion script for a shell",
            {"source <(impulse completion bash)", "impulse completion zsh > ~/.zfunc/_impulse",
             "impulse completion fish > ~/.config/fish/completions/impulse.fish"},
            addCompletion};
}

}  // namespace demos
