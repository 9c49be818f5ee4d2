/// A place in the source of a scene.
#pragma once

namespace demos {

/// Line and column count from 1. Files are numbered in the order in which their tables are read: an
/// included file comes before the one that includes it.
struct Place {
    int line = 0, column = 0;
    int file = 0;
};

}  // namespace demos
