#include "demos/scene/solver_words.h"

namespace demos {

const char* wordOf(engine::Method method) {
    switch (method) {
        case engine::Method::impulses:
            return "impulses";
        case engine::Method::pgs:
            return "pgs";
        case engine::Method::pgsMatrix:
            return "pgs-matrix";
        case engine::Method::direct:
            break;
    }
    return "direct";
}

const char* wordOf(engine::Order order) {
    return order == engine::Order::gravity ? "gravity" : "pairs";
}

const char* wordOf(engine::JointSolving joints) {
    return joints == engine::JointSolving::direct ? "direct" : "rows";
}

}  // namespace demos
