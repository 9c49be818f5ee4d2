/// SIGINT and SIGTERM as a question that a loop asks between two frames.
#pragma once

namespace demos {

/// From now on the first of them sets a flag; a second one ends the program at once.
/// Called again, the count begins anew.
void watchSignals();
bool interrupted();

}  // namespace demos
