/// What a table is read with: the names that its expressions may use, and where the reader's
/// questions are written down.
#pragma once
#include "demos/scene/catalog.h"
#include "demos/scene/expression.h"

namespace demos {

struct Scope {
    Expressions* expressions = nullptr;
    Turns turns;
    Catalog* catalog = nullptr;  // null: nobody wants to know
};

}  // namespace demos
