// `impulse slides` and `impulse site` in a build without slides.
#ifndef IMPULSE_HAVE_SLIDES

#include <CLI/CLI.hpp>

#include "demos/commands/commands.h"

namespace demos {

namespace {

/// A command that says that this build does not have it.
Run addNothing(CLI::App& app) {
    const std::string name = app.get_name();
    app.allow_extras();
    return [name](const std::string&) -> Exit {
        refuse(name + (name == "slides" ? " are" : " is") +
               " not supported by this build; build with -DIMPULSE_SLIDES=ON");
    };
}

}  // namespace

Command slidesCommand() {
    return {"slides",
            "not supported by this build",
            {"impulse export stack -o stack.html", "impulse gallery", "impulse strip stack"},
            addNothing};
}

Command siteCommand() {
    return {
        "site",
        "not supported by this build",
        {"impulse gallery", "impulse list --explain scene", "impulse export stack -o stack.html"},
        addNothing};
}

}  // namespace demos

#endif
