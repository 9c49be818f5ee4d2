#include <engine/world.h>

int main() {
    engine::World world;
    engine::BodyDef ball;
    ball.shape = engine::Shape::sphere(0.5);
    const engine::BodyId id = world.add(ball);
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60.0);
    return world.pose(id).position.y() < -4.8 ? 0 : 1;
}
