// Without slides and models, the commands and the reader report what the build does not support. Their sources
// are compiled here without the two; layering_tests check that no other file needs them.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "demos/commands/commands.h"
#include "demos/load/load_scene.h"
#include "demos/scene/description.h"
#include "demos/scene/reader.h"

namespace demos {
namespace {

std::string refusalOf(const Command& command) {
    CLI::App app("", command.name);
    const Run run = command.add(app);
    app.parse("stack -o out.html");  // whatever it is given
    try {
        run("");
    } catch (const Stop& stop) {
        EXPECT_EQ(stop.code(), Exit::usage);
        return stop.what();
    }
    return "not refused";
}

TEST(LeftOut, SlidesAndSiteSayWithWhatTheyAreBuilt) {
    EXPECT_EQ(refusalOf(slidesCommand()),
              "slides are not supported by this build; build with -DIMPULSE_SLIDES=ON");
    EXPECT_EQ(refusalOf(siteCommand()),
              "site is not supported by this build; build with -DIMPULSE_SLIDES=ON");
}

TEST(LeftOut, ModelsSayWithWhatTheyAreReadAndScenesAreRead) {
    EXPECT_FALSE(loadScene("stack").bodies.empty());
    try {
        loadScene("arm.xml");
        FAIL() << "a model was read";
    } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(), "arm.xml: MuJoCo's models are not supported by this build; build "
                                   "with -DIMPULSE_MJCF=ON");
    }
}

}  // namespace
}  // namespace demos
