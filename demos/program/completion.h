/// `impulse completion`: the commands and their options, for a shell.
#pragma once
#include "demos/commands/command.h"

namespace demos {

Command completionCommand();

}  // namespace demos
