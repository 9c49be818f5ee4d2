/// What one direction of contact is ahead of another before they are compared.
#pragma once

namespace engine {

/// A face keeps its place until another is better by this much, so that resting bodies do not
/// change their reference face, and with it all their features, for a rounding error.
constexpr double kFaceBonus = 5e-4;  // m
/// Edges give one point where a face gives four: they must be clearly better.
constexpr double kEdgeBonus = 2e-3;  // m

}  // namespace engine
