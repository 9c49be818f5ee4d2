/// E = m v^2 / 2 + w.(I w) / 2 - m g.(x - v h / 2), used to check everything else.
///
/// The velocities of semi-implicit Euler belong to half a sub-step ago. With the height of that moment, E is
/// constant in free fall to the last bits; with the present height it would vary by m g v h / 2 (Hairer,
/// Lubich, Wanner, 'Geometric Numerical Integration', IX: the modified energy).
#pragma once
#include "engine/dynamics/bodies.h"
#include "engine/step_report.h"

namespace engine {

/// Sum of m x over the dynamic bodies that are not active, kg m: their part of the potential energy.
Vec3 restMomentOf(const Bodies& bodies);
/// Keeps that sum in Bodies::restMoment, if it has changed.
void sumResting(Bodies& bodies);

/// Of a dynamic body, J.
double kineticEnergyOf(const Bodies& bodies, int i);

/// h: Bodies::spans, the sub-steps that produced the velocities.
Energy energyOf(const Bodies& bodies, const Vec3& gravity);

/// kg m/s, and kg m^2/s about the origin.
struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};
Momentum momentumOf(const Bodies& bodies);

}  // namespace engine
