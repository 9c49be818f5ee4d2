#include "engine/solver/prepare_contacts.h"

#include <algorithm>

#include "engine/constraints/manifold_frame.h"
#include "engine/dynamics/rotation.h"
#include "engine/solver/prepare_joints.h"

namespace engine {
namespace {

/// Places the points of a contact in one plane (constraints/manifold_frame.h). If the bodies are still apart,
/// the arms end where they will touch, as if b had moved by the gap.
void placePoints(const Contact& contact, const Pose& a, const Pose& b,
                 ContactGeometry (&points)[Contact::kMaxPoints]) {
    ManifoldFrame frame;
    Vec3 onA[Contact::kMaxPoints], onB[Contact::kMaxPoints];
    double open = 0.0;
    for (int i = 0; i < contact.count; ++i) {
        onA[i] = a.toWorld(contact.points[i].anchorA), onB[i] = b.toWorld(contact.points[i].anchorB);
        const double gap = contact.normal.dot(onB[i] - onA[i]);
        open = i == 0 ? gap : smaller(open, gap);
    }
    const Vec3 ahead = larger(open, 0.0) * contact.normal;
    for (int i = 0; i < contact.count; ++i)
        frame.add(0.5 * (onA[i] + onB[i] - ahead) - a.position + contact.slideA,
                  contact.normal.dot(onB[i] - onA[i]));
    frame.finish(contact.normal);
    const Vec3 offset = a.position - b.position + ahead + contact.slideB - contact.slideA;
    for (int i = 0; i < contact.count; ++i)
        points[i] = {frame.arm(i), frame.arm(i) + offset, frame.gap[i]};
}

/// Sorts the order by groups; within a group it stays.
void arrangeByGroups(Solver& solver) {
    const ContactGroups& groups = solver.groups;
    std::vector<int>& first = solver.firstOfGroup;
    first.assign(groups.count() + 1, 0);
    for (const int i : solver.order) ++first[groups.of(i) + 1];
    for (int g = 0; g < groups.count(); ++g) first[g + 1] += first[g];
    std::vector<int>& order = solver.constraints.order;
    order.resize(solver.order.size());
    for (const int i : solver.order) order[first[groups.of(i)]++] = i;
    first.insert(first.begin(), 0);
    first.pop_back();
}

constexpr double kLayer = 1e-3;  // m: closer contacts form one layer, in the order of pairs
constexpr double kMostLayers = 1e9;  // 1000 km: bodies are removed long before, but only after a step
constexpr double kStays = 0.02;  // m: a contact that has moved less keeps its place

}  // namespace

void orderContacts(std::span<Contact> contacts, const Bodies& bodies, const Vec3& gravity,
                   Order order, std::vector<std::uint64_t>& keys, std::vector<int>& result) {
    const double g = order == Order::gravity ? gravity.norm() : 0.0;
    const Vec3 down = g > 0.0 ? Vec3(gravity / g) : Vec3::Zero();
    keys.clear();
    for (Contact& contact : contacts) {
        const Vec3 at = bodies.poses[contact.a].toWorld(contact.points[0].anchorA);
        const double depth = down.dot(at);
        if (!(std::abs(depth - contact.depth) <= kStays))
            contact.depth = std::floor(depth / kLayer + 0.5) * kLayer;
        const double number = clamped(contact.depth / kLayer, -kMostLayers, kMostLayers);
        const auto layer = static_cast<std::uint32_t>(static_cast<std::int32_t>(number) + (1 << 30));
        keys.push_back(std::uint64_t{layer} << 32 | keys.size());
    }
    const auto ascends = [&](int i, int k) { return keys[i] < keys[k]; };
    if (result.size() == keys.size() && std::ranges::is_sorted(result, ascends)) return;  // as in the last step
    std::sort(keys.begin(), keys.end());
    result.clear();
    for (const std::uint64_t key : keys) result.push_back(static_cast<int>(key & 0xffffffffu));
}

void prepareContacts(std::span<Contact> contacts, std::span<const Joint> joints,
                     Bodies& bodies, const Settings& settings, Solver& solver) {
    Constraints& c = solver.constraints;
    c.contacts.clear();
    solver.pressed.unload(bodies);
    solver.pressed.load(contacts, joints, bodies);
    solver.posesAtStart.resize(bodies.count()), solver.velocitiesAtStart.resize(bodies.count());
    for (const int i : bodies.active)
        solver.posesAtStart[i] = bodies.poses[i], solver.velocitiesAtStart[i] = bodies.velocities[i];
    c.impacts.prepare(settings.bounce == Bounce::impacts ? contacts : contacts.first(0), joints, bodies);
    c.riding.find(contacts, joints, bodies, solver.islands);
    solver.lanes = settings.usesLanes();
    solver.byIsland = settings.solvesByIsland();
    if (solver.byIsland) {
        solver.groups.find(contacts, joints, bodies, solver.islands);
        groupJoints(bodies, solver);
    }
    if (solver.lanes) {
        solver.wide.prepare(contacts, solver.order, solver.groups, bodies, settings, solver.workers);
        c.order.clear();
        return;
    }
    if (solver.byIsland)
        arrangeByGroups(solver);
    else
        c.order = solver.order;
    for (const Contact& contact : contacts) {
        ContactGeometry points[Contact::kMaxPoints];
        placePoints(contact, bodies.poses[contact.a], bodies.poses[contact.b], points);
        c.contacts.push_back(makeContactConstraint(contact, points,
                                                   bodies.inverseMasses[contact.a],
                                                   bodies.inverseMasses[contact.b]));
    }
}

PointImpulses impulsesOf(const Solver& solver, int k, int i) {
    if (solver.lanes) return solver.wide.impulses(k, i);
    const ContactConstraint& c = solver.constraints.contacts[k];
    const ContactRow& row = c.rows[i];
    return {row.lambda, row.total, row.friction[0] * c.t1 + row.friction[1] * c.t2,
            row.totalFriction[0] * c.t1 + row.totalFriction[1] * c.t2};
}

double separationNow(const ContactConstraint& contact, const ContactRow& row, const Bodies& bodies,
                     const Solver& solver) {
    const auto since = [&](int body) {
        const Pose &now = bodies.poses[body], &start = solver.posesAtStart[body];
        return Velocity{now.position - start.position, turnBetween(start, now)};
    };
    return row.gapAtStart +
           contact.n.dot(velocityBetween(row, since(contact.a), since(contact.b)));
}

void updateSeparations(const Bodies& bodies, Solver& solver) {
    solver.constraints.impacts.begin(bodies, solver.posesAtStart);
    solver.constraints.riding.begin(bodies, solver.posesAtStart);
    chooseActingJoints(bodies, solver);
    if (solver.lanes) {  // separations are up to date from the nudges
        solver.wide.beginSubstep(bodies);
        solver.wide.followTurns(bodies);
        return;
    }
    const auto hasTurned = [&](int i) {
        return bodies.isDynamic(i) && !bodies.masses[i].isRound &&
               turnBetween(solver.posesAtStart[i], bodies.poses[i]).norm() > kFarTurn;
    };
    for (ContactConstraint& contact : solver.constraints.contacts) {
        const int body = bodies.movable(contact.a, contact.b);
        contact.stride = bodies.acts[body] ? bodies.strides[body] : 0;
        if (contact.stride == 0) continue;
        if (hasTurned(contact.a) || hasTurned(contact.b))
            setMasses(contact, bodies.inverseMasses[contact.a], bodies.inverseMasses[contact.b]);
        for (int i = 0; i < contact.count; ++i)
            contact.rows[i].separation =
                separationNow(contact, contact.rows[i], bodies, solver);
    }
}

void storeImpulses(const Solver& solver, std::span<Contact> contacts) {
    if (solver.lanes) {
        solver.wide.store(contacts);
        return;
    }
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        const ContactConstraint& c = solver.constraints.contacts[k];
        contacts[k].rollingMoment = c.rollingMoment[0] * c.t1 + c.rollingMoment[1] * c.t2;
        for (int i = 0; i < contacts[k].count; ++i) {
            const PointImpulses got = impulsesOf(solver, k, i);
            contacts[k].points[i].impulse = got.normal;
            contacts[k].points[i].friction = got.friction;
        }
    }
}

}  // namespace engine
