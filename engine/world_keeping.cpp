// World::saveState and restoreState: what is kept of a world, listed once for both directions
// (base/state_bytes.h). Left out is what every step computes again (rows, groups, batches), what the
// caller gives (shapes, settings, functions), and what can be built from the rest (trees of bounds
// and of joints).
//
// Arrays by body are kept whole, because a step visits only active bodies: what it left of the
// others when they came to rest still counts.
#include <algorithm>

#include "engine/base/state_bytes.h"
#include "engine/world_checks.h"

namespace engine {
namespace {

constexpr int kNumbers = 1 << 30;  // no limit but that of a number
constexpr double kTooLong = 1e6;   // s, of a step
constexpr double kTooFast = 1e40;  // of speeds and accelerations: their powers are still finite
constexpr double kOutside = 1e7;   // m: bodies are removed long before

/// Sorted pairs of different bodies of the world.
template <class Items, class PairOf>
bool arePairs(const Items& items, int bodies, PairOf pairOf) {
    return std::ranges::all_of(items, [&](const auto& item) {
        const PairKey pair = pairOf(item);
        return pair.a >= 0 && pair.a < pair.b && pair.b < bodies;
    });
}

/// Whether a step visits every body that can move.
bool areActive(const Bodies& bodies) {
    for (int i = 0; i < bodies.count(); ++i)
        if (bodies.present[i] && bodies.isDynamic(i) && bodies.isAwake(i) &&
            !std::ranges::binary_search(bodies.active, i))
            return false;
    return true;
}

/// Whether all numbers of bodies are those of bodies.
bool isSound(const WorldState& s) {
    const int count = s.bodies.count();
    const ContactFinder& finder = s.finder;
    const auto isPair = [](const PairKey& pair) { return pair; };
    const auto moves = [&](const PairKey& pair) {
        return s.bodies.isDynamic(pair.a) || s.bodies.isDynamic(pair.b);
    };
    const auto ofItem = [](const auto& item) { return item.pair; };
    const int bounded = finder.broadPhase.bodyCount();
    const int moved = static_cast<int>(finder.moving.motions.size());
    return areActive(s.bodies) && arePairs(finder.contacts, count, pairOf) &&
           arePairs(finder.asleep, count, pairOf) &&
           std::ranges::all_of(finder.contacts, moves, pairOf) && bounded <= count &&
           arePairs(finder.broadPhase.pairs(), bounded, isPair) &&
           std::ranges::all_of(finder.broadPhase.pairs(), moves) &&
           arePairs(finder.moving.entries, smaller(count, moved), ofItem) &&
           finder.moving.throws.size() == finder.moving.motions.size() &&
           std::ranges::all_of(finder.moving.thrown, [&](int i) { return i >= 0 && i < smaller(count, moved); }) &&
           arePairs(finder.sensed, count, ofItem) && arePairs(s.touches.before, count, ofItem) &&
           arePairs(s.touches.now, count, ofItem) && s.kept.size() <= 4 * 17 * kMostContacts;
}

}  // namespace

template <class Bytes>
void keep(Bytes& bytes, Pose& pose) {
    bytes(pose.position, pose.rotation);
}
template <class Bytes>
void keep(Bytes& bytes, Velocity& v) {
    bytes(v.linear, v.angular);
}
template <class Bytes>
void keep(Bytes& bytes, InverseMass& m) {
    bytes(m.linear, m.angular);
}
template <class Bytes>
void keep(Bytes& bytes, Load& load) {
    bytes(load.force, load.torque);
}
template <class Bytes>
void keep(Bytes& bytes, Acceleration& a) {
    bytes(a.linear, a.angular);
    bytes.require(a.linear.norm() < kTooFast && a.angular.norm() < kTooFast);
}
template <class Bytes>
void keep(Bytes& bytes, WideVelocity& v) {
    bytes(v.linear, v.angular);
}
template <class Bytes>
void keep(Bytes& bytes, PairKey& pair) {
    bytes(pair.a, pair.b);
}
template <class Bytes>
void keep(Bytes& bytes, BodyId& id) {
    bytes(id.index, id.generation);
}
template <class Bytes>
void keep(Bytes& bytes, JointId& id) {
    bytes(id.index, id.generation);
}
template <class Bytes>
void keep(Bytes& bytes, Motion& m) {
    bytes(m.start, m.velocity, m.spin, m.reach, m.sweep, m.size);
    bytes.require(m.start.position.norm() < kOutside && m.velocity.norm() < kTooFast &&
                  m.spin.norm() < kTooFast);
}
template <class Bytes>
void keep(Bytes& bytes, Sensed& sensed) {
    bytes(sensed.pair, sensed.position, sensed.normal);
}
template <class Bytes>
void keep(Bytes& bytes, Row& row) {
    bytes(row.j.linear, row.j.angularA, row.j.angularB);
    bytes(row.massA, row.massB, row.turnA, row.turnB, row.k);
}

template <class Bytes>
void keep(Bytes& bytes, MovingPairs::Entry& entry) {
    Impact& impact = entry.impact;
    bytes(entry.pair, impact.meets, impact.time, impact.distance, impact.closing);
    bytes.require(std::abs(impact.time) < kTooLong);
}

template <class Bytes>
void keep(Bytes& bytes, Contact& c) {
    bytes(c.a, c.b, c.normal, c.slideA, c.slideB, c.friction, c.restitution, c.rolling, c.rollingMoment, c.depth);
    bytes(c.normalA, c.seenFromA);
    bytes.within(c.count, 1, Contact::kMaxPoints);
    for (int i = 0; i < c.count; ++i) {
        ContactPoint& p = c.points[i];
        bytes(p.anchorA, p.anchorB, p.feature, p.impulse, p.friction);
        bytes.require(p.anchorA.norm() < kOutside && p.anchorB.norm() < kOutside);
    }
}

template <class Bytes>
void keep(Bytes& bytes, ContactState& c) {
    bytes(c.a, c.b, c.position, c.normal, c.penetration, c.impulse, c.friction, c.feature);
}

template <class Bytes>
void keep(Bytes& bytes, Touch& touch) {
    bytes(touch.pair, touch.sensor, touch.position, touch.normal, touch.speed, touch.impulse);
    bytes(touch.total);
}

template <class Bytes>
void keep(Bytes& bytes, TouchEvent& event) {
    bytes.within(event.kind, 0, 1);
    bytes(event.a, event.b, event.sensor, event.step, event.time, event.position, event.normal);
    bytes(event.speed, event.impulse);
}

template <class Bytes>
void keep(Bytes& bytes, SweepReport& sweep) {
    bytes(sweep.residual, sweep.delta, sweep.distance);
}

template <class Bytes>
void keep(Bytes& bytes, Incident& incident) {
    bytes.within(incident.trouble, 0, static_cast<int>(Trouble::tooManyContacts));
    bytes(incident.body);
}

template <class Bytes>
void keep(Bytes& bytes, StepReport& report) {
    bytes(report.step, report.time);
    bytes.within(report.substeps, 0, kNumbers);
    bytes(report.asleep, report.energy.kinetic, report.energy.potential, report.energy.elastic);
    bytes(report.residual, report.sweeps);
    DirectReport& direct = report.direct;
    bytes(direct.rows, direct.rank, direct.redundant, direct.contradiction, direct.found);
    bytes(report.broken, report.incidents);
    bytes.within(report.trouble, 0, static_cast<int>(Trouble::tooManyContacts));
}

template <class Bytes>
void keep(Bytes& bytes, Bodies& b) {
    const std::size_t count = b.defs.size();
    bytes.sized(count, b.poses, b.velocities, b.inverseMasses, b.massFactors, b.loads);
    bytes.sized(count, b.accelerations, b.spans, b.strides, b.acts, b.present, b.asleep, b.placed);
    bytes.upTo(count, b.active);
    bytes(b.activeShrinks, b.activeChanges, b.restStale, b.restMoment);
    if constexpr (!Bytes::kReads) return;
    const auto isBody = [&](int i) { return i >= 0 && i < b.count(); };
    bytes.require(std::ranges::all_of(b.active, isBody) && std::ranges::is_sorted(b.active));
    bytes.require(std::ranges::all_of(b.strides, [](int stride) { return stride >= 1; }));
    bytes.require(std::ranges::all_of(b.asleep, [&](int i) { return i == -1 || isBody(i); }));
    for (int i = 0; i < b.count() && bytes.isGood(); ++i)
        bytes.require(!b.present[i] ||
                      (b.poses[i].position.norm() < kOutside &&
                       b.velocities[i].linear.norm() < kTooFast &&
                       b.velocities[i].angular.norm() < kTooFast &&
                       std::abs(b.poses[i].rotation.norm() - 1.0) < 1e-6));
}

template <class Bytes>
void keep(Bytes& bytes, Freedom& f) {
    bytes(f.locked, f.limits.low, f.limits.high, f.motor.speed, f.motor.strength);
    bytes(f.spring.hz, f.spring.damping, f.spring.stiffness, f.spring.resistance);
    bytes(f.rest, f.inertia);
}

template <class Bytes>
void keep(Bytes& bytes, Joint& joint) {
    bytes(joint.present, joint.broken, joint.torn, joint.calm, joint.acts, joint.nearest);
    bytes(joint.position, joint.lambda, joint.force, joint.torque);
    const auto pieces = static_cast<double>(joint.def.path.size());
    bytes.require(joint.nearest >= 0.0 && joint.nearest <= pieces);
    if (joint.acts) bytes(joint.def.free, joint.driven);
    if constexpr (Bytes::kReads)
        for (Freedom& f : joint.def.free) {
            if (joint.acts) break;
            const bool locked = f.locked;
            f = {};
            f.locked = locked;
        }
}

template <class Bytes>
void keep(Bytes& bytes, JointConstraint& c) {
    bytes.within(c.count, 0, JointRows::kMaxRows);
    bytes(c.error, c.bend, c.bias, c.softness, c.lambda, c.kept);
}

template <class Bytes>
void keep(Bytes& bytes, JointDrive& drive) {
    for (int i = 0; i < drive.count; ++i) {
        DriveRow& row = drive.rows[i];
        bytes(row.sign, row.weight, row.error, row.bend, row.bias, row.softness, row.rate, row.low, row.high, row.lambda);
        bytes.require(row.weight > 0.0 && row.weight <= 1.0);
        bytes(drive.along[drive.placeOf(row)]);
    }
}

/// Rows and trees of the joints, unless the next step computes them again. Which there are follows from
/// the joints; so they are made, and then get their numbers.
template <class Bytes>
void keepRows(Bytes& bytes, WorldState& s) {
    if (s.jointsStale || s.treesStale || !bytes.isGood()) return;
    if constexpr (Bytes::kReads) collectJoints(s.joints, s.bodies, s.settings, s.solver);
    Constraints& c = s.solver.constraints;
    auto joints = static_cast<std::uint32_t>(c.joints.size());
    bytes(joints);
    if constexpr (Bytes::kReads) bytes.require(joints == c.joints.size());
    for (JointConstraint& joint : c.joints) {
        bytes(joint);
        if (joint.inTree && !s.settings.compareExact) continue;
        for (int i = 0; i < joint.count; ++i) bytes(joint.rows[i]);
    }
    for (JointDrive& drive : c.drives) bytes(drive);
    s.solver.trees.keep(bytes, s.bodies.inverseMasses);
    bytes(c.ratesStale);
}

template <class Bytes>
void keepForces(Bytes& bytes, WorldState& s) {
    for (std::optional<ForceDef>& force : s.forces) {
        bool acts = force.has_value();
        bytes(acts);
        if constexpr (Bytes::kReads) {
            bytes.require(force || !acts);
            if (!acts) force.reset();
        }
        if (force) bytes(force->on);
        if constexpr (Bytes::kReads)
            for (std::size_t i = 0; force && i < force->on.size(); ++i)
                bytes.require(s.bodySlots.knows(force->on[i].index, force->on[i].generation));
    }
    bytes(s.forceCount);
    if constexpr (Bytes::kReads)
        bytes.require(s.forceCount == std::ranges::count_if(s.forces, [](const auto& force) {
                          return force.has_value();
                      }));
}

template <class Bytes>
void keep(Bytes& bytes, ContactFinder& finder) {
    bytes(finder.broadPhase, finder.jointed, finder.moving.motions, finder.moving.entries);
    bytes(finder.moving.throws, finder.moving.thrown);
    bytes(finder.contacts, finder.asleep, finder.sensed, finder.tooMany);
}

/// Everything, in the order of the file.
template <class Bytes>
void keep(Bytes& bytes, WorldState& s) {
    const std::size_t bodies = s.bodies.defs.size();
    bytes(s.gravity, s.bodies);
    s.bodySlots.keep(bytes, s.bodies.count());
    s.jointSlots.keep(bytes, static_cast<int>(s.joints.size()));
    s.forceSlots.keep(bytes, static_cast<int>(s.forces.size()));
    for (Joint& joint : s.joints) bytes(joint);
    keepForces(bytes, s);
    bytes.upTo(bodies, s.untreed);
    for (int& body : s.untreed) bytes.within(body, 0, s.bodies.count() - 1);
    bytes(s.finder);
    bytes.upTo(bodies, s.scales, s.velocitiesBefore, s.solver.posesAtStart);
    s.substeps.keep(bytes, larger(s.settings.substeps, s.settings.maxSubsteps));
    bytes(s.solver.islands, s.solver.wide);
    s.sleep.keep(bytes, s.bodies.count());
    bytes(s.report, s.touches.watched, s.touches.before, s.touches.now, s.touches.events, s.kept);
    bytes(s.contactsStale, s.jointsStale, s.treesStale, s.startOfPace, s.stepsAtPace, s.lastDt);
    keepRows(bytes, s);
}

void World::saveState(std::vector<std::uint8_t>& bytes, std::size_t at) const {
    WorldState& s = *state_;
    checkIdle(s);
    if (s.listed != WorldState::Listed::kept) listContacts(s, s.kept);
    StateWriter writer(bytes, at);
    keep(writer, s);
    writer.finish();
}

bool World::restoreState(std::span<const std::uint8_t> bytes) {
    WorldState& s = *state_;
    checkIdle(s);
    StateReader reader(bytes);
    keep(reader, s);
    s.listed = WorldState::Listed::kept;
    s.solvedBefore.clear();
    return reader.isGood() && reader.isAtEnd() && isSound(s);
}

}  // namespace engine
