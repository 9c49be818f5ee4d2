/// Processes of our own that work for this one.
#pragma once
#include <sys/types.h>

#include <string>

namespace demos {

/// In a child, first of all: it ends with its parent, to which it leaves SIGINT and SIGTERM.
void becomeChildOf(pid_t parent);

/// Its status, when it has ended.
int waitFor(pid_t process);

/// Why a process gave no answer: "was ended by signal 11 (Segmentation fault)", "ended early".
std::string deathText(int status);

}  // namespace demos
