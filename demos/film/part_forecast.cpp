#include "demos/film/part_forecast.h"

#include <algorithm>
#include <cmath>

#include "demos/film/frame_choice.h"

namespace demos {

double PartForecast::frame() const {
    return std::max(simulate, (simulating * simulate + draw) / workers);
}

double PartForecast::simulationShare() const {
    const double together = simulate + draw;
    return together > 0.0 ? simulate / together : 0.0;
}

double PartForecast::alone() const { return start + begin + frames * frame(); }

double PartForecast::inParts() const {
    return start + begin + frames * (simulate + (frame() - simulate) / shards);
}

double PartForecast::processorRatio() const {
    double together = 0.0;
    for (int number = 1; number <= shards; ++number) {
        const Shard shard{number, shards};
        const int own = shard.end(frames) - shard.first(frames);
        together += start + workers * begin + simulating * simulate * shard.end(frames) + draw * own;
    }
    return together / (start + workers * begin + frames * (simulating * simulate + draw));
}

// (a + b) / n / (a + b / n) >= 1/2  <=>  n <= 2 + b / a, with a: what every part does, b: what they
// share
int PartForecast::partsThatPay() const {
    const double every = start + begin + frames * simulate, shared = frames * (frame() - simulate);
    const double most = std::min(frames, kMostShards);
    if (every <= 0.0) return static_cast<int>(most);
    return static_cast<int>(std::floor(std::min(2.0 + shared / every, most)));
}

}  // namespace demos
