// Milliseconds of processor time per frame: our default finish, then without the features that
// MuJoCo lacks (ambient occlusion, edge lines). `film_peer_impulse [PICTURE.png]`
#include <cstdio>

#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/renderer.h"
#include "tests/benchmark/film_peer.h"

using namespace film_peer;

int main(int argc, char** argv) {
    render::Frame frame;
    frame.camera.from = kFrom;
    frame.camera.lookAt = kLookAt;
    frame.camera.fovDegrees = 40.0f;
    frame.grounds.push_back({});
    frame.solids = bodies();
    render::RendererSettings settings;
    settings.width = kWidth, settings.height = kHeight;
    settings.samples = kSamples;
    settings.threads = 0;
    render::Renderer renderer(settings);
    render::Image image;
    const double all = timeFrames([&] { image = renderer.draw(frame); });
    frame.look.ambientOcclusion = frame.look.edges = false;
    const double same = timeFrames([&] { renderer.draw(frame); });
    if (argc > 1) render::writeFileAtomically(argv[1], render::encodePng(image));
    std::printf("%.2f %.2f\n", all, same);
}
