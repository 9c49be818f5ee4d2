/// A force that is affine in position and velocity, like springs, dampers and MuJoCo's actuators at
/// a constant control.
#pragma once
#include <map>
#include <string>

namespace demos::mjcf {

/// F = constant - stiffness q - resistance dq/dt, with q as MuJoCo counts it.
struct AffineForce {
    double constant = 0.0;    // N or N m
    double stiffness = 0.0;   // N/m or N m/rad
    double resistance = 0.0;  // N s/m or N m s/rad

    bool isConstant() const { return stiffness == 0.0 && resistance == 0.0; }
    /// The force along p if this one acts along q = gear p:  gear F(gear p, gear dp/dt)
    AffineForce geared(double gear) const {
        return {gear * constant, gear * gear * stiffness, gear * gear * resistance};
    }
    AffineForce& operator+=(const AffineForce& other) {
        constant += other.constant;
        stiffness += other.stiffness;
        resistance += other.resistance;
        return *this;
    }
};

/// The forces along joints, or along tendons, by name.
using ForcesByName = std::map<std::string, AffineForce>;

}  // namespace demos::mjcf
