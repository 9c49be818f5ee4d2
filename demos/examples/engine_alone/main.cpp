// Drops a ball on a crate, with the engine alone.
#include <engine/world.h>

#include <cstdio>

int main() {
    engine::World world;  // gravity is (0, -9.81, 0) m/s^2

    engine::BodyDef floor;
    floor.kind = engine::BodyKind::fixed;
    floor.shape = engine::Shape::plane({0, 1, 0});
    world.add(floor);

    engine::BodyDef crate;
    crate.shape = engine::Shape::box({1, 1, 1});  // m, full edges
    crate.pose.position = {0, 0.5, 0};
    crate.material.density = 600;  // kg/m^3
    world.add(crate);

    engine::BodyDef ball;
    ball.shape = engine::Shape::sphere(0.25);
    ball.pose.position = {0, 4, 0};
    ball.mass = 20;  // kg
    ball.material.restitution = 0.5;
    const engine::BodyId dropped = world.add(ball);

    for (int step = 0; step <= 300; ++step) {
        if (step % 30 == 0)
            std::printf("t = %.1f s  height %.4f m  speed %.4f m/s\n", world.report().time,
                        world.pose(dropped).position.y(), world.velocity(dropped).norm());
        if (!world.step(1.0 / 60)) {
            std::fprintf(stderr, "step %lld failed\n", world.report().step);
            return 1;
        }
    }
    double weight = 0;  // N: impulses of the last step over its length
    for (const engine::ContactState& contact : world.contacts())
        if (contact.b == dropped || contact.a == dropped) weight += contact.impulse * 60;
    std::printf("the crate carries %.1f N\n", weight);
}
