/// What commands that write films are asked for besides a picture.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demos/film/frame_choice.h"
#include "demos/options/options.h"

namespace demos {

struct FilmOptions : Options {
    std::vector<std::string> passes;       // data beside the frames
    std::string frames;                    // which, as in 120..179; empty: all
    std::optional<Shard> shard;            // a part of the film
    bool dryRun = false;                   // say what it would be, draw nothing
    std::optional<std::uint64_t> maxSize;  // bytes a film may have
    std::string poster;                    // a .png; empty = not asked for
    std::optional<double> posterTime;      // s
};

}  // namespace demos
