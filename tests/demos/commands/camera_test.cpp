// impulse render with a moving camera, run as by a user.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class CameraInAFilm : public SmallFilm {
protected:
    /// One second at 10 frames/s, by file name.
    Files framesOf(const std::string& scene, const std::vector<std::string>& more) {
        write(folder / "ball.toml", scene);
        std::vector<std::string> words{"-o", "out", "--overwrite", "--clean"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = film(words);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return framesIn(folder / "out");
    }
};

const std::string kStill = kBall + "[world]\ngravity = [0, 0, 0]\n";

TEST_F(CameraInAFilm, BlurDoesNotSmearOverACut) {
    Files frames = framesOf(kStill +
                                "[camera]\nfrom = [0, 3, 9]\nkeys = [{ at = 0.5, from = "
                                "[9, 3, 0], ease = 'cut' }]\n",
                            {"--blur", "4", "--shutter", "1"});
    EXPECT_EQ(frames["frame_000003.png"], frames["frame_000004.png"]);
    EXPECT_NE(frames["frame_000004.png"], frames["frame_000005.png"]);
    EXPECT_EQ(frames["frame_000005.png"], frames["frame_000006.png"]);  // both are after the cut
}

TEST_F(CameraInAFilm, WhatIsNotInFocusIsSoftInBlurredPictures) {
    const std::string scene = kStill + "[camera]\nfrom = [0, 3, 9]\nfocus = 2\naperture = ";
    const std::vector<std::string> sharp{"--seconds", "0.1"},
        blurred{"--seconds", "0.1", "--blur", "4"};
    EXPECT_EQ(framesOf(scene + "0\n", sharp), framesOf(scene + "0.3\n", sharp));
    EXPECT_NE(framesOf(scene + "0\n", blurred), framesOf(scene + "0.3\n", blurred));
}

// The lag is v dt q (1 - q^n) / (1 - q), q = exp(-dt / T), as in the pictures (camera_test.cpp).
TEST_F(CameraInAFilm, DataTellOfTheLagThatThePicturesShow) {
    framesOf(kStill +
                 "[[body]]\nname = 'runner'\nshape = { sphere = 0.2 }\nat = [0, 5, 0]\n"
                 "velocity = [3, 0, 0]\n"
                 "[camera]\nfrom = [0, 3, 9]\nfollow = 'runner'\nfollow_lag = 0.5\n",
             {"--pass", "camera"});
    const auto camera = nlohmann::json::parse(contentOf(folder / "out/camera/frame_000006.json"));
    const double dt = 1.0 / 60, q = std::exp(-dt / 0.5);
    const double behind = 3.0 * dt * q * (1.0 - std::pow(q, 36)) / (1.0 - q);
    EXPECT_NEAR(camera["position"][0].get<double>(), 3.0 * 0.6 - behind, 1e-5);
}

}  // namespace
}  // namespace demos::test
