/// A deck of scenes as they are: a slide for every [[section]], one for the numbers.
#pragma once
#include <string>
#include <vector>

#include "demos/options/options.h"
#include "demos/slides/deck.h"

namespace demos {

/// Throws SceneError. `options`: its scenes, --set, --seconds.
Deck deckOfScenes(const Options& options);

}  // namespace demos
