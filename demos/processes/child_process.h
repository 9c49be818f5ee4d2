/// Child processes of this program.
#pragma once
#include <sys/types.h>

#include <string>

namespace demos {

/// To be called first in a child: it is killed when its parent ends, and ignores SIGINT, SIGTERM
/// and SIGHUP, which the parent handles.
void becomeChildOf(pid_t parent);

/// Waits until the process has ended, and returns its status.
int waitFor(pid_t process);

/// Why a process gave no answer: "was killed by signal 11 (Segmentation fault)", "ended early".
std::string deathText(int status);

}  // namespace demos
