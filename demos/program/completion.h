/// `impulse completion`: the words of all commands, for a shell.
#pragma once
#include "demos/commands/command.h"

namespace demos {

Command completionCommand();

}  // namespace demos
