/// Springs, motors and limits along the free coordinates x of a joint, dx/dt = J v. Each has up to three
/// rows; a spring and an inertia share one:
///   spring   C = x - rest, soft (soft.h)
///   inertia  of a rotor that keeps its rate u of the sub-step before:  lambda = -I (J v - u), a soft row of
///            gamma = 1 / I, b = -u. In one row with the spring,
///              1/gamma = 1/gamma_s + I,  b = gamma (b_s / gamma_s - I u)
///            and the spring's k and c are for the mass that swings, 1/K + I
///   motor    J v - speed = 0,                 |lambda| <= strength h
///   limit    C = s (x - bound) >= 0 and s J for the nearer bound, s = 1 for the low one, -1 for the
///            high one:  s J v + b >= 0, lambda >= 0, with b = C / h, so that it can be reached in
///            this sub-step but not passed; for C < 0 see setBias. Equal bounds: an equality.
/// In every sweep the total is clamped to its bounds [low, high], like a contact's.
///
/// Where an angle is undefined (turning.h) its J has no bound: a motor on the twist of a joint that had swung by
/// nearly half a turn had 2,800 times its strength, and the impulse kept for the next sub-step, where J was another
/// one, threw the bodies away (torture world limbs 53). With the weight m of the angle, motors, limits and rotors act
/// along m J, of length 1 at most, for m C and m times the speed, and the strength of a motor fades as m. Springs have
/// a potential that fades (JointRows::fade).
///
/// An impulse along J alone would violate the rows J_r that the joint holds, and the sweep would alternate
/// between the two (a thousand times for a small bob on a long arm). So J is first projected:
///   J <- J - (J M^-1 J_r^T) (J_r M^-1 J_r^T)^-1 J_r
/// The rate is the same where J_r v = 0, and the impulse includes the joint's reaction: K then belongs to
/// what a motor has to turn, the inertia about the hinge.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

enum class DriveKind { spring, motor, limit };

struct DriveRow {
    DriveKind kind = DriveKind::limit;
    int coordinate = 0;
    bool fades = false;
    Freedom freedom;
    double weight = 1.0;           // m of an angle; J, C and the speed of a motor are multiplied by it
    double sign = 1.0;             // s of a limit
    double error = 0.0;            // C, m or rad
    double bend = 0.0;             // kappa of a limit (solver/chords.h), m/s or rad/s
    double bias = 0.0;             // b, m/s or rad/s
    double softness = 0.0;         // of a spring
    double rate = 0.0;             // m/s or rad/s, after the last solve; used with an inertia
    double before = 0.0;           // u, m/s or rad/s, before the sub-step's forces; used with a spring
    double low = 0.0, high = 0.0;  // bounds of lambda
    double lambda = 0.0;           // N s (N m s), in one sub-step

    int slot() const { return 3 * coordinate + static_cast<int>(kind); }  // in Joint::driven
};

struct JointDrive {
    static constexpr int kMaxRows = 18;
    int a = -1, b = -1;
    int joint = -1;                      // number in the world
    int stride = 1;                      // of its bodies; 0: they wait in this sub-step
    int count = 0;
    std::array<DriveRow, kMaxRows> rows;
    std::array<Row, 12> along;         // by place, projected off the rows that the joint holds
    Vec3 totalImpulse = Vec3::Zero();  // N s on b, over the whole step
    Vec3 totalTwist = Vec3::Zero();    // N m s on b about its centre of mass

    /// In `along`: springs on angles that may become undefined have their own J (JointRows::fade).
    int placeOf(const DriveRow& row) const { return row.coordinate + (row.fades ? 6 : 0); }
    const Row& alongOf(const DriveRow& row) const { return along[placeOf(row)]; }
    /// s J
    Row rowOf(const DriveRow& row) const {
        Row r = alongOf(row);
        r.j = {row.sign * r.j.linear, row.sign * r.j.angularA, row.sign * r.j.angularB};
        r.turnA *= row.sign, r.turnB *= row.sign;
        return r;
    }
};

/// Adds an impulse along one row to the joint's reaction; `push` applies it too.
inline void book(JointDrive& drive, const DriveRow& row, double lambda) {
    const Row& along = drive.alongOf(row);
    drive.totalImpulse += row.sign * lambda * along.j.linear;
    drive.totalTwist += row.sign * lambda * along.j.angularB;
}
inline void push(JointDrive& drive, const DriveRow& row, double lambda, Velocity& a, Velocity& b) {
    apply(drive.alongOf(row), row.sign * lambda, a, b);
    book(drive, row, lambda);
}

/// lambda = -(s J v + b + gamma total) / (K + gamma), with the total clamped; returns the change.
inline double pushWithin(const Row& along, DriveRow& row, const Velocity& a, const Velocity& b) {
    if (!(along.k > 0.0)) return 0.0;
    const double rate = row.sign * velocityAlong(along.j, a, b);
    const double before = row.lambda;
    const double lambda = -(rate + row.bias + row.softness * before) / (along.k + row.softness);
    row.lambda = clamped(before + lambda, row.low, row.high);
    return row.lambda - before;
}

/// The drive rows of a joint, springs first and limits last: in a sweep, the last row wins.
inline JointDrive driveOf(const JointDef& def) {
    JointDrive drive;
    drive.a = def.a.index, drive.b = def.b.index;
    for (const DriveKind kind : {DriveKind::spring, DriveKind::motor, DriveKind::limit})
        for (int i = 0; i < 6; ++i) {
            const Freedom& f = def.free[i];
            const bool acts = kind == DriveKind::spring  ? f.spring.isSoft() || f.inertia > 0.0
                              : kind == DriveKind::motor ? f.motor.isOn()
                                                         : f.limits.any();
            if (!acts) continue;
            DriveRow& row = drive.rows[drive.count++];
            row.kind = kind;
            row.coordinate = i;
            row.freedom = f;
            const bool fits = def.type != JointType::ball && def.type != JointType::sixDof && !def.spring.isSoft();
            row.fades = kind == DriveKind::spring && f.spring.isSoft() && f.inertia == 0.0 && !fits;
        }
    return drive;
}

/// Below this the weight of an angle counts: joints that fit have round-off.
constexpr double kFullWeight = 0.9999;

/// The weight of a coordinate in a row. Of a spring that fades it is in J.
inline double weightOf(const DriveRow& row, double weight) {
    constexpr double kLeast = 1e-9;  // times an unlimited strength it must be a number
    return row.fades || weight >= kFullWeight ? 1.0 : larger(weight, kLeast);
}

/// Sets C of a row, and selects the nearer bound of a limit.
inline void place(DriveRow& row, double x) {
    const Limits& limits = row.freedom.limits;
    if (row.kind == DriveKind::motor) return;
    if (row.kind == DriveKind::spring) {
        row.error = x - row.freedom.rest;
        return;
    }
    const double low = limits.low, high = limits.high;
    const bool lower = x - low <= high - x || low >= high;
    const double sign = lower ? 1.0 : -1.0;
    if (sign != row.sign) row.lambda = 0.0;
    row.sign = sign;
    row.error = sign > 0.0 ? x - low : high - x;
}

/// A limit whose bounds are equal.
inline bool isHeld(const DriveRow& row) {
    return row.freedom.limits.low >= row.freedom.limits.high;
}

/// 1 / (1/K + I)
inline double withInertia(double k, double inertia) { return k / (1.0 + k * inertia); }

/// A spring and an inertia, or one of the two.
inline SoftRow springRow(const DriveRow& row, double k, const Settings& settings, double h) {
    const double inertia = row.freedom.inertia;
    SoftRow soft;
    if (row.freedom.spring.isSoft())
        soft = softRow(row.freedom.spring, withInertia(k, inertia), row.error, row.before, h, settings.springs);
    if (inertia <= 0.0) return soft;
    const double stiff = soft.softness > 0.0 ? 1.0 / soft.softness : 0.0;
    const double softness = 1.0 / (stiff + inertia);
    return {softness, softness * (stiff * soft.bias - inertia * row.rate)};
}

/// Sets b, gamma and the bounds of lambda for a sub-step of length h (s).
inline void setBias(DriveRow& row, double k, const Settings& settings, double h) {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    row.low = -kAny, row.high = kAny;
    if (row.kind == DriveKind::spring) {
        const SoftRow soft = springRow(row, k, settings, h);
        row.softness = soft.softness;
        row.bias = soft.bias;
    } else if (row.kind == DriveKind::motor) {
        row.bias = -row.weight * row.freedom.motor.speed;
        row.high = row.weight * row.freedom.motor.strength * h;
        row.low = -row.high;
    } else {
        if (!isHeld(row)) row.low = 0.0;
        row.bias = (row.error > 0.0 && !isHeld(row) ? 1.0 : settings.baumgarte) * row.error / h + row.bend;
    }
}

}  // namespace engine
