/// The context in which a table is read: the names that its expressions may use, and the catalog
/// that records the reader's questions.
#pragma once
#include "demos/scene/catalog.h"
#include "demos/scene/expression.h"

namespace demos {

struct Scope {
    Expressions* expressions = nullptr;
    Turns turns;
    Catalog* catalog = nullptr;  // null: nothing is recorded
};

}  // namespace demos
