#include "tests/benchmark/peer_cost.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "tests/benchmark/peer_clock.h"

namespace peers {

namespace {

constexpr double kWindow = 2.0;  // s of simulated time

double median(std::span<const double> numbers) {
    if (numbers.empty()) return 0.0;
    std::vector<double> sorted(numbers.begin(), numbers.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

double medianOf(const std::vector<Cost>& runs, double Cost::*number) {
    std::vector<double> numbers;
    for (const Cost& run : runs) numbers.push_back(run.*number);
    return median(numbers);
}

}  // namespace

Cost measureCost(const Scene& scene, Engine& engine, double budget) {
    const double end = seconds(Clock::wall) + budget;
    std::vector<double> processor, wall;  // s, of each step
    engine.build(scene);
    for (int i = 0; i < scene.stepCount() && seconds(Clock::wall) < end; ++i) {
        const double wallBefore = seconds(Clock::wall), before = seconds(Clock::processor);
        const bool well = engine.step(scene.step);
        processor.push_back(seconds(Clock::processor) - before);
        wall.push_back(seconds(Clock::wall) - wallBefore);
        if (!well) break;
    }
    const std::size_t window =
        std::min<std::size_t>(processor.size(), std::lround(kWindow / scene.step));
    Cost cost;
    cost.first = median(std::span(processor).first(window));
    cost.last = median(std::span(processor).last(window));
    cost.wallFirst = median(std::span(wall).first(window));
    cost.wallLast = median(std::span(wall).last(window));
    cost.points = engine.contactPoints();
    cost.steps = static_cast<int>(processor.size());
    return cost;
}

Cost median(const std::vector<Cost>& runs) {
    Cost cost;
    for (double Cost::*number :
         {&Cost::first, &Cost::last, &Cost::wallFirst, &Cost::wallLast, &Cost::points})
        cost.*number = medianOf(runs, number);
    for (const Cost& run : runs) cost.steps = std::max(cost.steps, run.steps);
    return cost;
}

}  // namespace peers
