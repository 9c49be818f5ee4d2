// golden_hashes THREADS [baseline]: plays the golden worlds, with the instructions that every processor of its
// kind has where that is asked for. Prints each world's hash and that of the bytes of its saved state; fails if
// a hash is another one than in support/golden_worlds.h.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "engine/base/hash.h"
#include "tests/support/golden_worlds.h"

namespace {

std::uint64_t hashOf(const std::vector<std::uint8_t>& bytes) {
    engine::StateHash hash;
    for (const std::uint8_t byte : bytes) hash.add(std::uint64_t{byte});
    return hash.value();
}

/// Whether the world ends with the hash that is written down.
bool play(const support::GoldenWorld& golden, const engine::Settings& settings) {
    engine::World world = golden.make();
    world.setSettings(settings);
    for (int i = 0; i < golden.steps; ++i)
        if (!world.step(support::kStep)) return false;
    std::vector<std::uint8_t> state;
    world.saveState(state);
    std::printf("%s %016" PRIx64 " %016" PRIx64 " %s\n", golden.name, world.hash(), hashOf(state),
                world.hash() == golden.hash ? "equal" : "OTHER");
    return world.hash() == golden.hash;
}

}  // namespace

int main(int count, char** arguments) {
    engine::Settings settings = engine::Settings::steady();
    settings.threads = count > 1 ? std::atoi(arguments[1]) : 1;
    if (count > 2 && std::strcmp(arguments[2], "baseline") == 0)
        settings.instructions = engine::Instructions::baseline;
    bool equal = true;
    for (const support::GoldenWorld& golden : support::goldenWorlds())
        equal = play(golden, settings) && equal;
    return equal ? 0 : 1;
}
