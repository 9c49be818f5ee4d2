// A box falls on its edge and tips over, in five pictures: engine_and_render FOLDER
#include <engine/world.h>
#include <render/encode/file.h>
#include <render/encode/png.h>
#include <render/renderer.h>

#include <cstdio>
#include <string>

namespace {

/// Makes a picture's frame of the world: the only place that knows both libraries.
render::Frame frameOf(const engine::World& world, engine::BodyId box) {
    const engine::Pose& pose = world.pose(box);
    render::Solid solid;
    solid.halfSize = world.def(box).shape.halfSize.cast<float>();
    solid.position = pose.position.cast<float>();
    solid.rotation = pose.rotation.cast<float>();
    solid.color = {0.2f, 0.5f, 0.7f};
    render::Frame frame;
    frame.camera = {.from = {4, 3, 6}, .lookAt = {0, 1, 0}};
    frame.grounds = {render::Ground{}};
    frame.solids = {solid};
    return frame;
}

}  // namespace

int main(int count, char** arguments) try {
    const std::string folder = count > 1 ? arguments[1] : ".";
    engine::World world;
    world.add({.kind = engine::BodyKind::fixed, .shape = engine::Shape::plane({0, 1, 0})});
    engine::BodyDef def;
    def.shape = engine::Shape::box({1, 1.5, 1});
    def.pose = {.position = {0, 2, 0}, .rotation = {0.94, 0, 0, 0.34}};
    def.pose.rotation.normalize();
    const engine::BodyId box = world.add(def);

    render::Renderer renderer({.width = 320, .height = 180});
    for (int step = 0; step <= 60; ++step) {
        if (step % 15 == 0) {
            const std::string name = folder + "/box_" + std::to_string(step / 15) + ".png";
            const render::Image image = renderer.draw(frameOf(world, box));
            render::writeFileAtomically(name, render::encodePng(image));
            std::printf("%s: height %.4f m\n", name.c_str(), world.pose(box).position.y());
        }
        if (!world.step(1.0 / 60)) return 1;
    }
} catch (const render::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
