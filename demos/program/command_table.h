/// Every command, in the order of the help page.
#pragma once
#include <span>

#include "demos/commands/command.h"

namespace demos {

std::span<const Command> commandTable();

}  // namespace demos
