#include "engine/solver/drives.h"

#include <algorithm>

#include "engine/solver/block_factors.h"
#include "engine/solver/chords.h"
#include "engine/solver/joint_nudges.h"
#include "engine/solver/nudges.h"

namespace engine {
namespace {

using Block = Eigen::Matrix<double, 6, 6>;
using Rates = Eigen::Matrix<double, 6, 1>;

/// The rows that a joint holds rigidly.
class HeldRows {
public:
    HeldRows() = default;  // none
    HeldRows(const Joint& joint, const Bodies& bodies, int a, int b) {
        if (joint.def.spring.isSoft() || rowCount(joint.def) == 0) return;
        const JointRows held =
            rowsOf(joint.def.type, geometryOf(joint, bodies.poses[a], bodies.poses[b]));
        count_ = held.count;
        for (int i = 0; i < count_; ++i)
            rows_[i] = makeRow(held.j[i], bodies.inverseMasses[a], bodies.inverseMasses[b]);
        Rates scale = Rates::Zero();
        for (int i = 0; i < count_; ++i)
            for (int k = 0; k < count_; ++k) inverse_(i, k) = coupling(rows_[i], rows_[k]);
        for (int i = 0; i < count_; ++i) scale[i] = inverse_(i, i);
        sweepPivots<6>(inverse_, scale);
    }

    /// J - (J M^-1 J_r^T) (J_r M^-1 J_r^T)^-1 J_r
    Jacobian free(const Row& row) const {
        Rates across = Rates::Zero();
        for (int i = 0; i < count_; ++i) across[i] = coupling(row, rows_[i]);
        const Rates share = inverse_ * across;
        Jacobian j = row.j;
        for (int i = 0; i < count_; ++i) {
            j.linear -= share[i] * rows_[i].j.linear;
            j.angularA -= share[i] * rows_[i].j.angularA;
            j.angularB -= share[i] * rows_[i].j.angularB;
        }
        return j;
    }

private:
    int count_ = 0;
    std::array<Row, 6> rows_;
    Block inverse_ = Block::Zero();
};

/// A coordinate that the joint does hold has almost no K left, and cannot be driven.
constexpr double kNone = 1e-9;

Row freeRow(const HeldRows& held, const Jacobian& j, const InverseMass& a, const InverseMass& b) {
    const Row whole = makeRow(j, a, b);
    Row row = makeRow(held.free(whole), a, b);
    if (!(row.k > kNone * whole.k)) row.k = 0.0;
    return row;
}

/// Nudges one row, from the poses that the previous one left. True if it moved bodies.
bool nudgeRow(const Joint& joint, DriveRow row, Bodies& bodies, const Settings& settings) {
    const int a = joint.def.a.index, b = joint.def.b.index;
    const JointRows free = coordinatesOf(joint, bodies.poses[a], bodies.poses[b]);
    place(row, free.error[row.coordinate]);
    if (row.error >= 0.0 && !isHeld(row)) return false;
    const Row along = freeRow(HeldRows(joint, bodies, a, b), free.j[row.coordinate],
                              bodies.inverseMasses[a], bodies.inverseMasses[b]);
    if (along.k <= 0.0) return false;
    const double c = clamped(settings.nudgeFactor * row.error, -kMostNudge, kMostNudge);
    Velocity wayA, wayB;  // m, rad
    apply(along, -row.sign * c / along.k, wayA, wayB);
    moveBy(wayA, a, bodies);
    moveBy(wayB, b, bodies);
    return true;
}

/// Neither bound of a limit is near, by its position before the sub-step and its rate since.
bool isFar(const JointDrive& drive, const DriveRow& row, std::span<const Velocity> v, double h) {
    constexpr double kClear = 0.05;  // m, rad
    if (isHeld(row) || row.error < kClear) return false;
    const Limits& limits = row.freedom.limits;
    const double rate = velocityAlong(drive.alongOf(row).j, v[drive.a], v[drive.b]);
    const double span = limits.high - limits.low;  // distance between the bounds
    return row.error > kClear + h * std::abs(rate) && span - row.error > kClear + h * std::abs(rate);
}

/// A limit so far away that only a hard impact brings the coordinate there within h (s), which is stopped
/// without the projection. `rate`: of the coordinate now.
bool hardlyActs(const DriveRow& row, double rate, double h) {
    constexpr double kWide = 0.3;  // m, rad
    return row.kind == DriveKind::limit && row.lambda == 0.0 && !isHeld(row) &&
           row.error > kWide + 8.0 * h * std::abs(rate);
}

/// Sets C of a row, and forgets a limit's impulse where J turns fast with the bodies.
void placeIn(const JointRows& free, DriveRow& row) {
    constexpr double kSteady = 0.5;  // weight
    place(row, free.error[row.coordinate]);
    row.weight = weightOf(row, free.weight[row.coordinate]);
    if (row.kind == DriveKind::limit) row.lambda *= smaller(row.weight / kSteady, 1.0);
    row.error *= row.weight;
}

/// J of a row, with its weight; sets C of a spring that fades.
Jacobian jacobianIn(const JointRows& free, DriveRow& row) {
    Jacobian j = free.j[row.coordinate];
    if (row.fades) {
        JointRows own = free;
        own.fade(row.coordinate, row.freedom.rest);
        j = own.j[row.coordinate], row.error = own.error[row.coordinate];
    } else if (row.weight < 1.0) {
        j.angularA *= row.weight, j.angularB *= row.weight;
    }
    return j;
}

/// Of limits, if any may act.
void setBends(const Joint& joint, const JointRows& now, const Bodies& bodies, bool mayAct, JointDrive& drive) {
    const std::span<DriveRow> rows = std::span(drive.rows).first(drive.count);
    for (DriveRow& row : rows) row.bend = 0.0;
    if (!mayAct || std::ranges::none_of(rows, [](const DriveRow& row) { return row.kind == DriveKind::limit; })) return;
    const Chord chord(bodies, drive.a, drive.b);
    if (chord.h == 0.0 || joint.def.type == JointType::path) return;
    const JointRows atEnd = coordinatesOf(joint, chord.a, chord.b);
    for (DriveRow& row : rows) {
        if (row.kind != DriveKind::limit) continue;
        const int i = row.coordinate;
        const double rate = velocityAlong(now.j[i], bodies.velocities[drive.a], bodies.velocities[drive.b]);
        row.bend = row.sign * row.weight * chord.bend(atEnd.error[i], now.error[i], rate);
    }
}

/// Of a coordinate, by k and c.
Spring springOf(const Joint& joint, int coordinate) {
    const Freedom& f = joint.def.free[coordinate];
    return f.spring.fixedFor(withInertia(joint.freeMasses[coordinate], f.inertia));
}

}  // namespace

void measureMasses(Joint& joint, const Bodies& bodies) {
    const int a = joint.def.a.index, b = joint.def.b.index;
    const InverseMass &massA = bodies.inverseMasses[a], &massB = bodies.inverseMasses[b];
    const JointRows rows = rowsOf(joint.def.type, geometryOf(joint, bodies.poses[a], bodies.poses[b]));
    for (int i = 0; i < rows.count; ++i) joint.rowMasses[i] = makeRow(rows.j[i], massA, massB).k;
    const JointRows free = coordinatesOf(joint, bodies.poses[a], bodies.poses[b]);
    const HeldRows held(joint, bodies, a, b);
    for (int i = 0; i < free.count; ++i)
        joint.freeMasses[i] = freeRow(held, free.j[i], massA, massB).k;
}

JointDrive makeDrive(const Joint& joint, int number) {
    JointDrive drive = driveOf(joint.def);
    drive.joint = number;
    for (int i = 0; i < drive.count; ++i) {
        DriveRow& row = drive.rows[i];
        row.freedom.spring = springOf(joint, row.coordinate);
        const double kept = joint.driven[row.slot()];
        if (row.kind == DriveKind::limit && kept < 0.0) row.sign = -1.0;
        row.lambda = row.sign * kept;
    }
    return drive;
}

void prepareDrives(std::span<Joint> joints, const Bodies& bodies, int group, Constraints& c) {
    for (const int k : c.drivesByGroup.of(group)) {
        JointDrive& drive = c.drives[k];
        Joint& joint = joints[drive.joint];
        const Pose &a = bodies.poses[drive.a], &b = bodies.poses[drive.b];
        const JointRows free = followCoordinates(joint, a, b);
        bool far = true;
        for (DriveRow& row : std::span(drive.rows).first(drive.count)) {
            placeIn(free, row);
            const double rate = velocityAlong(free.j[row.coordinate], bodies.velocities[drive.a],
                                              bodies.velocities[drive.b]);
            const double h = bodies.spans[bodies.movable(drive.a, drive.b)];
            far = far && hardlyActs(row, rate, h);
        }
        setBends(joint, free, bodies, !far, drive);
        const InverseMass &massA = bodies.inverseMasses[drive.a], &massB = bodies.inverseMasses[drive.b];
        const HeldRows held = far ? HeldRows() : HeldRows(joint, bodies, drive.a, drive.b);
        for (DriveRow& row : std::span(drive.rows).first(drive.count))
            drive.along[drive.placeOf(row)] = freeRow(held, jacobianIn(free, row), massA, massB);
    }
}

void setDriveBiases(Constraints& c, const Settings& settings, double h) {
    for (JointDrive& drive : c.drives)
        for (int i = 0; drive.stride > 0 && i < drive.count; ++i)
            setBias(drive.rows[i], drive.alongOf(drive.rows[i]).k, settings, drive.stride * h);
}

void measureSprings(Constraints& c, const Bodies& bodies) {
    const std::span<const Velocity> v = bodies.velocities;
    for (JointConstraint& joint : c.joints) {
        if (!joint.spring.isSoft() || !bodies.act(joint.a, joint.b)) continue;
        for (int i = 0; i < joint.count; ++i)
            joint.before[i] = velocityAlong(joint.rows[i].j, v[joint.a], v[joint.b]);
    }
    for (JointDrive& drive : c.drives) {
        if (!bodies.act(drive.a, drive.b)) continue;
        for (DriveRow& row : std::span(drive.rows).first(drive.count))
            if (row.kind == DriveKind::spring)
                row.before = velocityAlong(drive.alongOf(row).j, v[drive.a], v[drive.b]);
    }
}

void keepRates(Constraints& c, const Bodies& bodies) {
    c.ratesStale = false;
    const std::span<const Velocity> v = bodies.velocities;
    for (JointDrive& drive : c.drives) {
        if (!bodies.act(drive.a, drive.b)) continue;
        for (DriveRow& row : std::span(drive.rows).first(drive.count))
            if (row.kind == DriveKind::spring && row.freedom.inertia > 0.0)
                row.rate = velocityAlong(drive.alongOf(row).j, v[drive.a], v[drive.b]);
    }
}

void warmStartDrives(Constraints& c, double keep, std::span<Velocity> v) {
    for (JointDrive& drive : c.drives)
        for (int i = 0; drive.stride > 0 && i < drive.count; ++i) {
            DriveRow& row = drive.rows[i];
            row.lambda = clamped(keep * row.lambda, row.low, row.high);
            push(drive, row, row.lambda, v[drive.a], v[drive.b]);
        }
}

void sweepDrive(JointDrive& drive, std::span<Velocity> v, Correction& correction) {
    for (int i = 0; i < drive.count; ++i) {
        DriveRow& row = drive.rows[i];
        const Row& along = drive.alongOf(row);
        Velocity &a = v[drive.a], &b = v[drive.b];
        const double lambda = pushWithin(along, row, a, b);
        if (lambda == 0.0) continue;  // most limits are far away
        push(drive, row, lambda, a, b);
        correction.add((along.k + row.softness) * lambda, lambda);
    }
}

bool nudgeDrives(std::span<const Joint> joints, Bodies& bodies, const Constraints& c, int group,
                 const Settings& settings, double h) {
    bool moved = false;
    for (const int k : c.drivesByGroup.of(group)) {
        const JointDrive& drive = c.drives[k];
        for (const DriveRow& row : std::span(drive.rows).first(drive.count))
            if (row.kind == DriveKind::limit && !isFar(drive, row, bodies.velocities, drive.stride * h))
                moved = nudgeRow(joints[drive.joint], row, bodies, settings) || moved;
    }
    return moved;
}

void storeDrives(const Constraints& c, const Bodies& bodies, std::span<Joint> joints, double dt) {
    for (const JointDrive& drive : c.drives) {
        Joint& joint = joints[drive.joint];
        for (int i = 0; i < drive.count; ++i)
            joint.driven[drive.rows[i].slot()] = drive.rows[i].sign * drive.rows[i].lambda;
        const Vec3 armB = bodies.poses[drive.b].rotation * joint.def.anchorB;
        const Vec3 force = drive.totalImpulse / dt;
        joint.force += force;
        joint.torque += drive.totalTwist / dt - armB.cross(force);
    }
}

double driveEnergy(const Joint& joint, const Bodies& bodies, double h) {
    const auto isSoft = [](const Freedom& f) { return f.spring.isSoft(); };
    if (std::ranges::none_of(joint.def.free, isSoft)) return 0.0;
    const int a = joint.def.a.index, b = joint.def.b.index;
    JointRows free = coordinatesOf(joint, bodies.poses[a], bodies.poses[b]);
    const HeldRows held(joint, bodies, a, b);
    double energy = 0.0;
    for (int i = 0; i < free.count; ++i) {
        const Freedom& f = joint.def.free[i];
        if (!f.spring.isSoft()) continue;
        free.fade(i, f.rest);
        const double rate = velocityAlong(free.j[i], bodies.velocities[a], bodies.velocities[b]);
        const double stretch = free.error[i] - 0.5 * h * rate;
        const double k =
            freeRow(held, free.j[i], bodies.inverseMasses[a], bodies.inverseMasses[b]).k;
        if (k > 0.0) energy += 0.5 * springOf(joint, i).stiffness * stretch * stretch;
    }
    return energy;
}

double rotorEnergy(const Joint& joint, const Bodies& bodies) {
    const auto turns = [](const Freedom& f) { return f.inertia > 0.0; };
    if (std::ranges::none_of(joint.def.free, turns)) return 0.0;
    const int a = joint.def.a.index, b = joint.def.b.index;
    const JointRows free = coordinatesOf(joint, bodies.poses[a], bodies.poses[b]);
    double energy = 0.0;
    for (int i = 0; i < free.count; ++i) {
        const double inertia = joint.def.free[i].inertia;
        if (inertia <= 0.0) continue;
        const double weight = free.weight[i] < kFullWeight ? free.weight[i] : 1.0;
        const double rate = weight * velocityAlong(free.j[i], bodies.velocities[a], bodies.velocities[b]);
        energy += 0.5 * inertia * rate * rate;
    }
    return energy;
}

}  // namespace engine
