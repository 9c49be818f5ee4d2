#include "demos/program/completion.h"

#include <fmt/format.h>

#include "demos/commands/shared_options.h"
#include "demos/load/builtin.h"
#include "demos/program/parse.h"

namespace demos {
namespace {

Exit completion() {
    std::string names, cases;
    for (const CommandWords& command : commandWords()) {
        names += (names.empty() ? "" : " ") + command.name;
        cases += fmt::format("        {}) words=\"{}\" ;;\n", command.name,
                             fmt::join(command.options, " "));
    }
    std::string scenes;
    for (const BuiltinScene& scene : builtinScenes())
        scenes += (scenes.empty() ? "" : " ") + std::string(scene.name);
    fmt::print(R"(# bash completion for impulse; load it with: source <(impulse completion bash)
_impulse() {{
    local word="${{COMP_WORDS[COMP_CWORD]}}" words=""
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "{} --help --version" -- "$word"))
        return
    fi
    case "${{COMP_WORDS[1]}}" in
{}    esac
    [[ "$word" == -* ]] || words="{}"
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _impulse impulse
)",
               names, cases, scenes);
    return Exit::ok;
}

Run addCompletion(CLI::App& app) {
    const auto shell = std::make_shared<std::string>("bash");
    app.add_option("shell", *shell, "bash; default: bash")->type_name("SHELL");
    return [shell](const std::string&) {
        checkName("shell", *shell, {"bash"});
        return completion();
    };
}

}  // namespace

Command completionCommand() {
    return {"completion",
            "a completion script for a shell",
            {"impulse completion bash", "source <(impulse completion bash)",
             "impulse completion bash > ~/.local/share/bash-completion/completions/impulse"},
            addCompletion};
}

}  // namespace demos
