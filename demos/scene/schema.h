/// A JSON Schema (draft 2020-12) of scene files, for editors. It is made of what the reader asks.
#pragma once
#include <string>

namespace demos {

class Catalog;

/// What the reader asks of the scenes of every_key.h.
Catalog formatCatalog();

std::string sceneSchema();

}  // namespace demos
