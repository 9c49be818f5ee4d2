/// Bonuses added to a contact direction before directions are compared.
#pragma once

namespace engine {

/// Another face must be better by this much to replace the reference face, so that a rounding error
/// does not change the reference face of resting bodies, and with it all their features.
constexpr double kFaceBonus = 5e-4;  // m
/// Edges must be clearly better, because they give one point where a face gives four.
constexpr double kEdgeBonus = 2e-3;  // m

}  // namespace engine
