// `impulse slides` in a build without slides.
#ifndef IMPULSE_HAVE_SLIDES

#include <CLI/CLI.hpp>

#include "demos/commands/commands.h"

namespace demos {

Command slidesCommand() {
    const auto add = [](CLI::App& app) -> Run {
        app.allow_extras();
        return [](const std::string&) -> Exit {
            refuse("slides are not supported by this build; build with -DIMPULSE_SLIDES=ON");
        };
    };
    return {"slides",
            "not supported by this build",
            {"impulse export stack -o stack.html", "impulse gallery", "impulse strip stack"},
            add};
}

}  // namespace demos

#endif
