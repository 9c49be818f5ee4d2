#include "engine/collision/seams.h"

#include <algorithm>

#include "engine/collision/contact_making.h"
#include "engine/collision/convex.h"

namespace engine {
namespace {

constexpr double kSteep = 0.5;     // cosine: below it, a contact does not help to support the body
constexpr double kAbove = 1e-3;    // m: lower steps do not count
constexpr double kInPlane = 2e-3;  // m, plus the depth that the body has sunk in
constexpr double kSeated = 2e-3;   // m: farther from the tile, its plane means nothing yet

/// The extent of a shape along n, m; kFar where it is not known.
double topOf(const Shape& shape, const Pose& pose, const Vec3& n) {
    if (shape.type == ShapeType::plane || shape.type == ShapeType::mesh) return kFar;
    if (shape.type != ShapeType::compound) {
        const Convex convex(shape, pose);
        return n.dot(convex.support(n)) + convex.radius();
    }
    double top = -kFar;
    for (const ShapePart& part : *shape.parts)
        top = larger(top, topOf(part.shape,
                                {pose.toWorld(part.pose.position),
                                 pose.rotation * part.pose.rotation}, n));
    return top;
}

/// A contact, with its normal and points on the tile's side.
struct OnTile {
    const Contact& contact;
    const Bodies& bodies;
    int tile;
    Vec3 n;  // out of the tile

    OnTile(const Contact& c, int body, const Bodies& all)
        : contact(c), bodies(all), tile(c.a == body ? c.b : c.a),
          n(c.a == tile ? c.normal : Vec3(-c.normal)) {}

    Vec3 point(int i) const {
        const ContactPoint& p = contact.points[i];
        return bodies.poses[tile].toWorld(tile == contact.a ? p.anchorA : p.anchorB);
    }
};

/// How far from the seat's plane a point may be that was found ahead of time (moving_contacts.h), m: it has
/// been moved by the body's motion until then.
double movedOut(double cosine, double way) {
    return cosine > kSteep ? way * std::sqrt(larger(1.0 - cosine * cosine, 0.0)) : 0.0;
}

/// `way` (m): how far the body moves within the step.
bool hides(const OnTile& seat, const OnTile& other, double way) {
    const double cosine = seat.n.dot(other.n), deepest = deepestOf(seat.contact, seat.bodies);
    if (deepest > kSeated) return false;
    const double d = seat.n.dot(seat.point(0));
    const double in = kInPlane + larger(-deepest, 0.0) + movedOut(cosine, way);
    for (int i = 0; i < other.contact.count; ++i)
        if (std::abs(seat.n.dot(other.point(i)) - d) > in) return false;
    const Bodies& bodies = seat.bodies;
    return topOf(bodies.defs[other.tile].shape, bodies.poses[other.tile], seat.n) <= d + kAbove;
}

void turn(Contact& contact, const Vec3& normal, const Bodies& bodies) {
    contact.normal = normal;
    contact.normalA = bodies.poses[contact.a].rotation.conjugate() * normal;
}

}  // namespace

void Seams::leaveOut(const Bodies& bodies, double dt, std::vector<Contact>& contacts) {
    seats_.clear();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& c = contacts[k];
        const bool movesA = bodies.inverseMasses[c.a].linear > 0.0;
        if (movesA && bodies.inverseMasses[c.b].linear > 0.0) continue;
        const int body = movesA ? c.a : c.b, tile = movesA ? c.b : c.a;
        if (bodies.defs[tile].kind == BodyKind::fixed)
            seats_.push_back({body, static_cast<int>(k)});
    }
    std::ranges::sort(seats_);
    hidden_.assign(contacts.size(), 0);
    for (std::size_t first = 0; first < seats_.size();) {
        std::size_t end = first + 1;
        while (end < seats_.size() && seats_[end].body == seats_[first].body) ++end;
        if (end > first + 1) look(bodies, dt, contacts, first, end);
        first = end;
    }
    if (std::ranges::count(hidden_, 0) == std::ssize(hidden_)) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (hidden_[k]) continue;
        if (kept != k) contacts[kept] = contacts[k];
        ++kept;
    }
    contacts.resize(kept);
}

void Seams::look(const Bodies& bodies, double dt, std::vector<Contact>& contacts,
                 std::size_t first, std::size_t end) {
    const int body = seats_[first].body;
    const double way = dt * bodies.velocities[body].linear.norm();
    for (std::size_t i = first; i < end; ++i)
        for (std::size_t j = first; j < end; ++j) {
            const int on = seats_[i].contact, at = seats_[j].contact;
            if (i == j || hidden_[on] || hidden_[at]) continue;
            const OnTile seat(contacts[on], body, bodies), other(contacts[at], body, bodies);
            if (seat.n == other.n || !hides(seat, other, way)) continue;
            if (seat.n.dot(other.n) < kSteep)
                hidden_[at] = 1;
            else
                turn(contacts[at], other.tile == contacts[at].a ? seat.n : Vec3(-seat.n), bodies);
        }
}

}  // namespace engine
