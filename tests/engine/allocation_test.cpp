// A steady step allocates nothing: operator new is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/golden_worlds.h"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* p = std::malloc(size > 0 ? size : 1)) return p;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
// If it were inlined without its operator new, GCC would warn that free() does not match.
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace engine {
namespace {

TEST(Allocation, ASteadyStepOfAStackMakesNone) {
    World world = support::stack(10);
    support::run(world, 120);
    const long before = allocations;
    support::run(world, 120);
    EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, ASteadyStepOfAChainMakesNone) {
    World world;
    BodyId last = world.add(support::hook());
    for (int i = 0; i < 10; ++i) {
        const BodyId next = world.add(support::body(Shape::capsule(0.1, 0.5), {0, -0.5 * i - 0.25, 0}));
        support::join(world, JointType::ball, last, next, {0, -0.5 * i, 0});
        last = next;
    }
    support::run(world, 300);
    const long before = allocations;
    support::run(world, 60);
    EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, ASteadyStepWithForcesSensorsAndEventsMakesNone) {
    World world = support::stack(3);
    BodyDef sensor = support::fixed(Shape::box({3, 3, 3}));
    sensor.sensor = true;
    world.add(sensor);
    const std::vector<BodyId> on{{1}, {2}, {3}};
    world.add(ForceDef{Medium{.velocity = {1, 0, 0}}, on});
    world.add(ForceDef{NBodyGravity{}, on});
    world.watchTouches(true);
    support::run(world, 120);
    const long before = allocations;
    support::run(world, 120);
    EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, AStepOfAMachineMakesNone) {
    World world = support::goldenMachineThat(false);
    support::run(world, 120);
    const long before = allocations;
    support::run(world, 60);
    EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, TheCounterCounts) {
    const long before = allocations;
    ::operator delete(::operator new(8));
    EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace engine
