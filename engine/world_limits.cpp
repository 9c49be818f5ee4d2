#include "engine/world_limits.h"

#include <algorithm>

namespace engine {
namespace {

constexpr double kFastest = 1e4;   // m/s or rad/s
constexpr double kFarthest = 1e5;  // m

bool isFinite(const Bodies& bodies, int i) {
    return bodies.poses[i].position.allFinite() && bodies.poses[i].rotation.coeffs().allFinite() &&
           bodies.velocities[i].linear.allFinite() && bodies.velocities[i].angular.allFinite();
}

Trouble notFinite(const Pose& pose) {
    return pose.position.allFinite() && pose.rotation.coeffs().allFinite()
               ? Trouble::velocityNotFinite
               : Trouble::positionNotFinite;
}

/// False also for what is not a number.
bool isWithin(const Vec3& v, double most) {
    return std::abs(v.x()) <= most && std::abs(v.y()) <= most && std::abs(v.z()) <= most;
}

/// Limits every component of v to `most`.
void limit(Vec3& v, double most) {
    if (!isWithin(v, most)) v *= most / v.cwiseAbs().maxCoeff();
}

/// The bodies that began the step with non-finite values, or that a force gave the first of them; if there are
/// none, all that `ended` so.
std::vector<Incident> culprits(const WorldState& s, const std::vector<Incident>& ended) {
    std::vector<Incident> first;
    for (const Incident& incident : ended) {
        const int i = incident.body.index;
        if (!isFinite(s.bodies, i) || std::ranges::binary_search(s.badlyLoaded, i)) first.push_back(incident);
    }
    return first.empty() ? ended : first;
}

}  // namespace

void limitSpeeds(WorldState& s) {
    const bool isFirst = s.badlyLoaded.empty();
    for (const int i : s.bodies.active) {
        Velocity& v = s.bodies.velocities[i];
        if (v.linear.squaredNorm() + v.angular.squaredNorm() <= kFastest * kFastest) continue;  // nearly all
        if (!s.bodies.isMoving(i)) continue;
        if (isWithin(v.linear, kFastest) && isWithin(v.angular, kFastest)) continue;
        if (!v.linear.allFinite() || !v.angular.allFinite()) {
            if (isFirst) s.badlyLoaded.push_back(i);  // later ones may be consequences
            continue;
        }
        limit(v.linear, kFastest), limit(v.angular, kFastest);
        Acceleration& a = s.bodies.accelerations[i];  // impacts look ahead with it
        limit(a.linear, kFastest), limit(a.angular, kFastest);
        const auto at = std::ranges::lower_bound(s.tooFast, i);
        if (at == s.tooFast.end() || *at != i) s.tooFast.insert(at, i);
    }
}

void reportTooFast(WorldState& s) {
    for (const int i : s.tooFast)
        if (s.bodies.present[i]) s.report.incidents.push_back({Trouble::velocityTooLarge, s.bodyId(i)});
}

void removeTheFar(WorldState& s) {
    for (const int i : s.bodies.active) {
        if (!s.bodies.isMoving(i)) continue;
        if (s.bodies.poses[i].position.cwiseAbs().maxCoeff() <= kFarthest) continue;
        s.report.incidents.push_back({Trouble::positionTooLarge, s.bodyId(i)});
        removeBody(s, s.bodyId(i));
    }
}

bool staysFinite(WorldState& s) {
    std::vector<Incident> ended;
    for (const int i : s.bodies.active)
        if (s.bodies.isMoving(i) && !isFinite(s.bodies, i))
            ended.push_back({notFinite(s.bodies.poses[i]), s.bodyId(i)});
    if (ended.empty()) return true;
    goBack(s);
    for (const Incident& incident : culprits(s, ended)) {
        s.report.incidents.push_back(incident);
        removeBody(s, incident.body);
    }
    for (std::vector<Contact>* contacts : {&s.finder.contacts, &s.finder.previous})
        contacts->clear();  // their impulses may not be finite either
    s.jointsStale = s.contactsStale = s.again = true;
    return false;
}

}  // namespace engine
