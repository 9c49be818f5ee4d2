#include "engine/world_touches.h"

#include <algorithm>

#include "engine/world_state.h"

namespace engine {
namespace {

/// The approach speed of the two bodies at p along n, m/s.
double approachAt(const Vec3& p, const Vec3& n, const PairKey& pair, std::span<const Pose> poses,
                  std::span<const Velocity> velocities) {
    const auto velocityOf = [&](int body) {
        const Vec3 arm = p - poses[body].position;
        return Vec3(velocities[body].linear + velocities[body].angular.cross(arm));
    };
    return n.dot(velocityOf(pair.a) - velocityOf(pair.b));
}

/// The touching points of one pair become one touch, at their mean.
void addContacts(const WorldState& s, std::vector<Touch>& touches) {
    const std::vector<ContactState>& points = s.touches.points;
    for (std::size_t i = 0; i < points.size();) {
        Touch touch;
        touch.pair = {points[i].a.index, points[i].b.index};
        touch.normal = points[i].normal;
        int count = 0;
        for (; i < points.size() && PairKey{points[i].a.index, points[i].b.index} == touch.pair;
             ++i) {
            const ContactState& point = points[i];
            if (point.penetration < 0.0 && point.impulse <= 0.0) continue;
            const double speed = approachAt(point.position, point.normal, touch.pair,
                                            s.solver.posesAtStart, s.velocitiesBefore);
            touch.position += point.position;
            touch.speed = larger(touch.speed, speed);
            touch.impulse += point.impulse;
            ++count;
        }
        if (count == 0) continue;
        touch.position /= count;
        touches.push_back(touch);
    }
}

void addSensed(const WorldState& s, std::vector<Touch>& touches) {
    for (const Sensed& sensed : s.finder.sensed) {
        Touch touch;
        touch.pair = sensed.pair;
        touch.sensor = true;
        touch.position = sensed.position;
        touch.normal = sensed.normal;
        touch.speed = larger(approachAt(sensed.position, sensed.normal, sensed.pair,
                                        s.bodies.poses, s.bodies.velocities), 0.0);
        touches.push_back(touch);
    }
}

TouchEvent eventOf(const Touch& touch, TouchEvent::Kind kind, const WorldState& s) {
    const bool begins = kind == TouchEvent::Kind::begin;
    return {kind, s.bodyId(touch.pair.a), s.bodyId(touch.pair.b), touch.sensor, s.report.step,
            s.report.time,
            touch.position, touch.normal, begins ? touch.speed : 0.0,
            begins ? touch.impulse : touch.total};
}

}  // namespace

void recordTouches(WorldState& s) {
    TouchLog& log = s.touches;
    log.now.swap(log.before);
    log.now.clear();
    log.events.clear();
    listContacts(s, log.points);
    addContacts(s, log.now);
    addSensed(s, log.now);
    std::sort(log.now.begin(), log.now.end(),
              [](const Touch& l, const Touch& r) { return l.pair < r.pair; });
    auto old = log.before.cbegin();
    const auto endsBefore = [&](const PairKey* pair) {
        for (; old != log.before.cend() && (!pair || old->pair < *pair); ++old)
            log.events.push_back(eventOf(*old, TouchEvent::Kind::end, s));
    };
    for (Touch& touch : log.now) {
        endsBefore(&touch.pair);
        touch.total = touch.impulse;
        if (old != log.before.cend() && old->pair == touch.pair)
            touch.total += (old++)->total;
        else
            log.events.push_back(eventOf(touch, TouchEvent::Kind::begin, s));
    }
    endsBefore(nullptr);
}

}  // namespace engine
