/// The options of commands that write films, besides those of a picture.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demos/film/frame_choice.h"
#include "demos/options/options.h"

namespace demos {

struct FilmOptions : Options {
    std::vector<std::string> passes;       // data next to the frames
    std::string frames;                    // which, as in 120..179; empty: all
    std::optional<Shard> shard;            // a part of the film
    std::string states;                    // a folder with states to start from; empty: none
    bool dryRun = false;                   // report what would be made, draw nothing
    std::optional<std::uint64_t> maxSize;  // largest size of a film in bytes
    std::string poster;                    // a .png; empty = none
    std::optional<double> posterTime;      // s
    std::string captions;                  // a .vtt; empty = none
};

}  // namespace demos
