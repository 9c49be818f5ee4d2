/// Vectors in the JSON of a film's data.
#pragma once
#include <nlohmann/json.hpp>

namespace demos {

/// [x, y, z]
template <class Vector>
nlohmann::ordered_json listOf(const Vector& v) {
    return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

}  // namespace demos
