/// A deck made from scenes: a slide for every [[section]], one for the numbers.
#pragma once
#include <string>
#include <vector>

#include "demos/options/options.h"
#include "demos/slides/deck.h"

namespace demos {

/// Throws SceneError. `options`: the scenes, --set, --seconds.
Deck deckOfScenes(const Options& options);

}  // namespace demos
