// Milliseconds to compare two pictures of the size that snapshots have by default (640x360). The
// costliest pair differs at every pixel; the cheapest, and by far the most frequent, nowhere.
#include <benchmark/benchmark.h>

#include <cstdint>

#include "render/difference.h"

namespace {

render::Image noise(std::uint32_t seed) {
    render::Image image{640, 360, {}};
    image.pixels.resize(std::size_t{4} * image.width * image.height);
    for (std::uint8_t& value : image.pixels) {
        seed = seed * 1664525u + 1013904223u;  // Numerical Recipes, 'Quick and dirty generators'
        value = static_cast<std::uint8_t>(seed >> 24);
    }
    return image;
}

void compareOther(benchmark::State& state) {
    const render::Image a = noise(1), b = noise(2);
    for (auto _ : state) benchmark::DoNotOptimize(render::compare(a, b));
}

void compareSame(benchmark::State& state) {
    const render::Image a = noise(1), b = noise(1);
    for (auto _ : state) benchmark::DoNotOptimize(render::compare(a, b));
}

BENCHMARK(compareOther)->Name("compare/differs everywhere")->Unit(benchmark::kMillisecond);
BENCHMARK(compareSame)->Name("compare/the same")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
