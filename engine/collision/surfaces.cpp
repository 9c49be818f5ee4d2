#include "engine/collision/surfaces.h"

#include "engine/base/math.h"

namespace engine {
namespace {

double frictionOf(FrictionRule rule, double a, double b) {
    switch (rule) {
        case FrictionRule::none: return 0.0;
        case FrictionRule::geometric: return std::sqrt(a * b);
        case FrictionRule::average: return 0.5 * (a + b);
        case FrictionRule::smaller: return smaller(a, b);
        case FrictionRule::product: return a * b;
        case FrictionRule::larger: return larger(a, b);
    }
    return 0.0;
}

Material alone(Material material) {
    if (material.frictionRule == FrictionRule::none) material.friction = 0.0;
    return material;
}

}  // namespace

Material together(const Material& a, const Material& b) {
    if (a.priority != b.priority) return alone(a.priority > b.priority ? a : b);
    Material both;
    both.priority = a.priority;
    both.frictionRule = larger(a.frictionRule, b.frictionRule);
    both.friction = frictionOf(both.frictionRule, a.friction, b.friction);
    both.restitution = larger(a.restitution, b.restitution);
    both.rolling = larger(a.rolling, b.rolling);
    return both;
}

}  // namespace engine
