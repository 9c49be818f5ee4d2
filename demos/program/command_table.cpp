#include "demos/program/command_table.h"

#include "demos/commands/commands.h"
#include "demos/program/completion.h"
#include "demos/program/manual.h"

namespace demos {

std::span<const Command> commandTable() {
    static const Command commands[] = {
        renderCommand(),  joinCommand(),   farmCommand(),   planCommand(),    stillCommand(),
        stripCommand(),   simCommand(),    plotCommand(),   compareCommand(), sweepCommand(),
        exportCommand(),  slidesCommand(), watchCommand(),  galleryCommand(), siteCommand(),
        testCommand(),    approveCommand(), listCommand(),  doctorCommand(),  benchCommand(),
        completionCommand(), manCommand(),
    };
    return commands;
}

}  // namespace demos
