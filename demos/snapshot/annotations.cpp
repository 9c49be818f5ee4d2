// Names of the vectors of one contact or joint: n, p_a, p_b, r_a, r_b and their lengths.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "demos/snapshot/camera.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/joint_bars.h"
#include "demos/snapshot/scale.h"
#include "engine/shapes/bounds.h"
#include "render/palette.h"

namespace demos {
namespace {

constexpr double kNormalOfView = 0.14;  // of the view's height: the length of n
constexpr double kSeenOfView = 0.02;    // of the view's height: shorter lengths have no name
constexpr float kNeverHidden = 1e3f;         // m: what is explained is never hidden
constexpr float kNameSize = 25.0f;

render::Color colorOfA() { return render::fromHex(0x0f8a63); }
render::Color colorOfB() { return render::fromHex(0xc4511a); }

/// What is explained: two points, the bodies that they belong to, and a direction.
struct Subject {
    engine::BodyId a, b;
    Vec3 onA, onB;  // m
    Vec3 normal{0, 0, 0};      // unit, from a to b; zero: none
    const char* gap = "";      // the name of the distance between the points
    double gapLength = 0.0;    // m, with its sign
    bool isContact = false;
};

std::string lengthText(double meters) {
    const double size = std::abs(meters);
    return fmt::format(" = {}{:.3g} {}", meters < 0.0 ? "\u2212" : "",
                       size < 0.1 ? 1e3 * size : size, size < 0.1 ? "mm" : "m");
}

/// Whether the body has a centre that a picture can show.
bool hasCentre(const Stage& stage, engine::BodyId body) {
    return bodyPlace(stage, body) >= 0 &&
           stage.world.def(body).shape.type != engine::ShapeType::plane;
}

/// Of the pair with the largest impulse, the contact that is nearest to the camera. The contacts of
/// a pair follow each other.
std::optional<Subject> strongestContact(const Stage& stage, const Vec3& eye) {
    const std::vector<engine::ContactState>& contacts = stage.world.contacts();
    const auto away = [&](const engine::ContactState& contact) {
        return (contact.position - eye).norm();
    };
    const engine::ContactState* best = nullptr;
    std::pair<bool, double> most;
    for (auto first = contacts.begin(); first != contacts.end();) {
        const auto isOther = [&](const engine::ContactState& contact) {
            return contact.a != first->a || contact.b != first->b;
        };
        const auto end = std::find_if(first, contacts.end(), isOther);
        std::pair<bool, double> rank(hasCentre(stage, first->a) && hasCentre(stage, first->b), 0.0);
        for (auto contact = first; contact != end; ++contact) rank.second += contact->impulse;
        if (!best || most < rank) {
            most = rank;
            best = &*std::min_element(first, end, [&](const auto& x, const auto& y) {
                return away(x) < away(y);
            });
        }
        first = end;
    }
    if (!best) return {};
    // The points are where each surface is: a's is ahead of b's if they overlap.
    const Vec3 half = 0.5 * best->penetration * best->normal;
    return Subject{best->a,      best->b, best->position + half, best->position - half,
                   best->normal, "c",     -best->penetration,    true};
}

std::optional<Subject> strongestJoint(const Stage& stage) {
    std::optional<Subject> best;
    double most = -1.0;
    for (const engine::JointId id : stage.joints) {
        const engine::JointState joint = stage.world.joint(id);
        if (joint.removed || joint.force.norm() <= most) continue;
        most = joint.force.norm();
        best = Subject{joint.def.a, joint.def.b, joint.worldA, joint.worldB};
        const Vec3 way = joint.worldB - joint.worldA;
        if (joint.def.type != engine::JointType::distance || !(way.norm() > 0.0)) continue;
        best->normal = way.normalized();
        best->gap = "l";
        best->gapLength = way.norm();
    }
    return best;
}

class Annotations {
public:
    Annotations(const Stage& stage, render::Frame& frame)
        : stage_(stage), frame_(frame), view_(viewHeight(stage.scene.camera)) {}

    void add(const Subject& subject) {
        keepClear(subject.a);
        keepClear(subject.b);
        addPoint(subject.onA, "a", colorOfA());
        addPoint(subject.onB, "b", colorOfB());
        addGap(subject);
        addArm(subject.a, subject.onA, "a", colorOfA());
        addArm(subject.b, subject.onB, "b", colorOfB());
        if (!subject.normal.isZero()) addNormal(subject);
    }

private:
    /// Names with a value, which are long, stand beside the bodies.
    void keepClear(engine::BodyId body) {
        if (!hasCentre(stage_, body)) return;
        const engine::Bounds own = engine::boundsOf(stage_.world.def(body).shape, {});
        for (int i = 0; i < 8; ++i) {
            const Vec3 corner((i & 1 ? own.high : own.low).x(), (i & 2 ? own.high : own.low).y(),
                              (i & 4 ? own.high : own.low).z());
            bodies_.push_back(drawn(stage_.world.pose(body).toWorld(corner)));
        }
    }
    void name(const char* text, const char* subscript, std::string value, const Vec3& at,
              const render::Color& color) {
        render::Label label{text, drawn(at), kNeverHidden, kNameSize};
        label.subscript = subscript;
        if (!value.empty()) label.clearOf = bodies_;
        label.value = std::move(value);
        label.beside = true;
        label.color = color;
        frame_.labels.push_back(std::move(label));
    }
    void arrow(const Vec3& from, const Vec3& to, const render::Color& color) {
        frame_.arrows.push_back({drawn(from), drawn(to), color, kNeverHidden});
    }
    void addPoint(const Vec3& at, const char* body, const render::Color& color) {
        render::Marker dot{drawn(at), 5.0f, color};
        dot.reach = kNeverHidden;
        frame_.markers.push_back(dot);
        name("p", body, {}, at, color);
    }
    /// From the centre of mass to the point.
    void addArm(engine::BodyId body, const Vec3& at, const char* which,
                const render::Color& color) {
        if (!hasCentre(stage_, body)) return;
        const Vec3 centre = stage_.world.pose(body).position;
        const double length = (at - centre).norm();
        if (length < kSeenOfView * view_) return;
        arrow(centre, at, color);
        render::Marker mark{drawn(centre), 7.0f, color};
        mark.reach = kNeverHidden;
        mark.shape = render::MarkerShape::quartered;
        frame_.markers.push_back(mark);
        name("r", which, lengthText(length), 0.5 * (centre + at), color);
    }
    /// It starts between the points; for a joint at the end of the gap, which it would cover.
    void addNormal(const Subject& subject) {
        const Vec3 from = subject.isContact ? Vec3(0.5 * (subject.onA + subject.onB)) : subject.onB;
        const Vec3 to = from + kNormalOfView * view_ * subject.normal;
        arrow(from, to, render::normalColor());
        name("n", "", {}, to, render::normalColor());
    }
    void addGap(const Subject& subject) {
        if (std::abs(subject.gapLength) < kSeenOfView * view_) return;
        const render::Color color = render::impulseColor();
        frame_.lines.push_back({drawn(subject.onA), drawn(subject.onB), 3.0f, color});
        name(subject.gap, "", lengthText(subject.gapLength), 0.5 * (subject.onA + subject.onB),
             color);
    }

    const Stage& stage_;
    render::Frame& frame_;
    std::vector<render::Vec3> bodies_;  // m: the corners of their bounds
    double view_;  // m, the view's height
};

}  // namespace

void addAnnotations(const Moment& moment, render::Frame& frame) {
    std::optional<Subject> subject =
        strongestContact(moment.stage, frame.camera.from.cast<double>());
    if (!subject) subject = strongestJoint(moment.stage);
    if (subject) Annotations(moment.stage, frame).add(*subject);
}

}  // namespace demos
