/// `impulse man`: the manual page.
#pragma once
#include "demos/commands/command.h"

namespace demos {

Command manCommand();

}  // namespace demos
