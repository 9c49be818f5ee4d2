/// The list of all keys of a scene file, from what `impulse list --explain` says.
#pragma once
#include "demos/site/document_html.h"

namespace demos {

/// Each key has its path as id: "solver.sweeps".
DocumentHtml keyReference();

}  // namespace demos
