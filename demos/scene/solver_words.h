/// The words of [solver] for the engine's enumerations.
#pragma once
#include "engine/settings.h"

namespace demos {

const char* wordOf(engine::Method method);
const char* wordOf(engine::Order order);
const char* wordOf(engine::JointSolving joints);

}  // namespace demos
