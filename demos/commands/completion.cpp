#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/scene/builtin.h"

namespace demos {

Exit completionCommand(const Options&) {
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

}  // namespace demos
