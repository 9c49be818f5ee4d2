/// A JSON Schema (draft 2020-12) of scene files, for editors, generated from the reader's catalog.
#pragma once
#include <string>

namespace demos {

class Catalog;

/// The keys that the reader asks for in the scenes of every_key.h, which are read once.
const Catalog& formatCatalog();

std::string sceneSchema();

}  // namespace demos
