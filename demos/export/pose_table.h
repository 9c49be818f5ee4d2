/// Poses and velocities as a table, one row per time and body: for `impulse export` and `sim`.
#pragma once
#include "demos/export/recording.h"
#include "demos/text/table.h"

namespace demos {

/// s; a name; m; a rotation as w x y z; m/s; rad/s.
inline constexpr const char* kPoseColumns = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";

void addPoseRow(double time, const std::string& body, const BodyMotion& motion, Table& table);

/// All frames of a run, for `target`.
Table poseTable(const std::string& target, const Recording& recording);

}  // namespace demos
