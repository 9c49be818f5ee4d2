#include "demos/commands/commands.h"
#include "demos/film/film.h"

namespace demos {

Exit renderCommand(const Options& options) {
    makeFilm(planFilm(options), options);
    return Exit::ok;
}

}  // namespace demos
