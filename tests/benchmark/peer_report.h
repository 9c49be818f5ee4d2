/// The benchmark's result for one scene and engine: a line for programs, a line for people.
#pragma once
#include <optional>
#include <string>

#include "tests/benchmark/peer_cost.h"
#include "tests/benchmark/peer_quality.h"

namespace peers {

struct Result {
    Scene scene;
    std::string preset;
    int threads = 1;
    std::optional<Quality> quality;
    std::optional<Cost> cost;
};

/// One line of JSON: metres, seconds, degrees. Values that do not apply to the scene are left out.
std::string json(const Result& result);

/// Scene, engine, cost and verdict in columns.
std::string tableLine(const Result& result);

}  // namespace peers
