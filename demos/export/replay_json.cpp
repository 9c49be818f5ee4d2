// The data that the page's script reads (page/decode.js). Lengths in m, rotations x y z w.
#include "demos/export/replay_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "demos/export/replay_codec.h"
#include "demos/look/theme.h"
#include "demos/text/rounded.h"
#include "render/material.h"
#include "render/solid_mesh.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::uint16_t>;

/// Six digits are finer than a screen and shorter than all seventeen.
Json shortOf(double value) {
    return std::isfinite(value) ? Json(rounded(value, 6)) : Json();
}

Json listOf(const auto& vector) {
    Json list = Json::array();
    for (const auto& value : vector) list.push_back(shortOf(static_cast<double>(value)));
    return list;
}

Json listOf(const engine::Quat& q) { return listOf(q.coeffs()); }
Json listOf(const render::Color& c) { return listOf(std::array{c.r, c.g, c.b, c.a}); }

Json jsonOf(const render::Look& look) {
    Json json{{"sun", listOf(look.sunDirection)},
              {"lines", shortOf(static_cast<double>(look.lineStrength))}};
    json["skyTop"] = listOf(look.skyTop);
    json["skyHorizon"] = listOf(look.skyHorizon);
    json["fog"] = listOf(look.fog);
    json["ground"] = listOf(look.ground);
    return json;
}

/// For readers who prefer a dark colour scheme.
render::Look darkLook() {
    render::Frame frame;
    applyTheme("dark", frame);
    return frame.look;
}

const char* nameOf(render::SolidShape shape) {
    constexpr const char* kNames[] = {"box", "sphere", "capsule", "cylinder", "cone", "mesh"};
    return kNames[static_cast<int>(shape)];
}

/// The contacts with an impulse in the step that ends here.
std::vector<engine::ContactState> pushing(const RecordedFrame& frame) {
    std::vector<engine::ContactState> contacts;
    std::copy_if(frame.contacts.begin(), frame.contacts.end(), std::back_inserter(contacts),
                 [](const engine::ContactState& contact) { return contact.impulse > 0.0; });
    return contacts;
}

/// Each mesh once, however many bodies share it.
class Meshes {
public:
    int numberOf(const std::shared_ptr<const render::SolidMesh>& mesh) {
        const auto [place, isNew] = numbers_.try_emplace(mesh, static_cast<int>(numbers_.size()));
        if (isNew) list_.push_back(meshJson(*mesh));
        return place->second;
    }
    const Json& list() const { return list_; }

private:
    /// Vertex numbers of corners take two words, the low one first.
    static Json meshJson(const render::SolidMesh& mesh) {
        Words points, corners;
        for (int axis = 0; axis < 3; ++axis)
            for (const render::Vec3& vertex : mesh.vertices)
                points.push_back(rangeAlong(mesh, axis).wordOf(static_cast<double>(vertex[axis])));
        for (int half = 0; half < 2; ++half)
            for (const auto& triangle : mesh.triangles)
                for (const int corner : triangle)
                    corners.push_back(static_cast<std::uint16_t>(corner >> (16 * half) & 0xffff));
        return {{"half", listOf(mesh.halfSize)},
                {"convex", mesh.convex},
                {"vertices", mesh.vertices.size()},
                {"triangles", mesh.triangles.size()},
                {"points", textOfColumns(points, mesh.vertices.size())},
                {"corners", textOfColumns(corners, 3 * mesh.triangles.size())}};
    }
    static WordRange rangeAlong(const render::SolidMesh& mesh, int axis) {
        const auto half = static_cast<double>(mesh.halfSize[axis]);
        return {-half, 2.0 * half};
    }

    std::map<std::shared_ptr<const render::SolidMesh>, int> numbers_;  // never iterated
    Json list_ = Json::array();
};

Json partJson(const DrawnPart& part, Meshes& meshes) {
    Json json{{"shape", nameOf(part.solid.shape)}};
    if (part.solid.mesh)
        json["mesh"] = meshes.numberOf(part.solid.mesh);
    else
        json["half"] = listOf(part.solid.halfSize);
    if (!part.place.position.isZero()) json["at"] = listOf(part.place.position);
    if (!part.place.rotation.isApprox(engine::Quat::Identity()))
        json["turn"] = listOf(part.place.rotation);
    return json;
}

/// The frames that a page shows, and their JSON.
class RunJson {
public:
    RunJson(const Recording& recording, const ReplayShare& share)
        : recording_(recording), share_(share) {
        for (std::size_t i = 0; i < recording.frames.size(); i += share.every)
            frames_.push_back(&recording.frames[i]);
    }

    Json json() {
        Json page = general();
        page["bodies"] = bodies();
        page["meshes"] = meshes_.list();
        page["tracks"] = textOfColumns(tracks_, frames_.size());
        page["contacts"] = contacts();
        page["joints"] = joints();
        page["bars"] = bars();
        page["cameras"] = cameras();
        page["curves"] = curves();
        return page;
    }

private:
    Json general() const {
        const Recording& r = recording_;
        Json page{{"name", r.name},
                  {"title", r.title},
                  {"fps", shortOf(r.framesASecond / static_cast<double>(share_.every))},
                  {"seconds", shortOf(r.seconds)},
                  {"frames", frames_.size()},
                  {"aspect", shortOf(r.aspect)},
                  {"viewHeight", shortOf(r.viewHeight)},
                  {"gridReach", shortOf(static_cast<double>(r.look.gridReach))},
                  {"thinnest", shortOf(r.thinnest)},
                  {"look", jsonOf(r.look)},
                  {"dark", jsonOf(darkLook())},
                  {"themed", r.overlays.theme != "studio"},
                  {"trails", r.trails}};
        page["grounds"] = Json::array();
        for (const render::Ground& ground : r.grounds)
            page["grounds"].push_back({{"normal", listOf(ground.normal)},
                                       {"offset", shortOf(static_cast<double>(ground.offset))}});
        page["sections"] = Json::array();
        for (const Section& section : r.sections)
            page["sections"].push_back({{"at", shortOf(section.at)},
                                        {"name", section.name},
                                        {"caption", section.caption}});
        page["show"] = shown();
        return page;
    }

    Json shown() const {
        const Overlays& o = recording_.overlays;
        Json show = Json::array();
        const std::pair<const char*, bool> all[] = {
            {"contacts", o.contacts}, {"normals", o.normals}, {"impulses", o.impulses},
            {"friction", o.friction}, {"joints", o.joints},   {"trails", o.trails},
            {"names", o.ids}};
        for (const auto& [name, on] : all)
            if (on) show.push_back(name);
        return show;
    }

    Json bodies() {
        Json list = Json::array();
        for (std::size_t i = 0; i < recording_.bodies.size(); ++i) {
            const RecordedBody& body = recording_.bodies[i];
            const render::MaterialValues& look = render::valuesOf(body.look);
            Json json{{"name", body.name},
                      {"color", listOf(body.color)},
                      {"material", listOf(std::array{look.roughness, look.metallic})},
                      {"mass", shortOf(body.mass)},
                      {"parts", Json::array()}};
            for (const DrawnPart& part : body.parts)
                json["parts"].push_back(partJson(part, meshes_));
            addMotion(i, json);
            list.push_back(std::move(json));
        }
        return list;
    }

    void addMotion(std::size_t body, Json& json) {
        const engine::Pose& first = frames_.front()->bodies[body].pose;
        const bool still = std::all_of(frames_.begin(), frames_.end(), [&](const auto* frame) {
            return frame->bodies[body].pose.position == first.position &&
                   frame->bodies[body].pose.rotation.coeffs() == first.rotation.coeffs();
        });
        if (still) {
            json["at"] = listOf(first.position);
            json["turn"] = listOf(first.rotation);
            return;
        }
        json["ranges"] = Json::array();  // of x, y, z and the speed: low, size
        for (int axis = 0; axis < 3; ++axis)
            json["ranges"].push_back(
                addTrack([&](const RecordedFrame& f) { return f.bodies[body].pose.position[axis]; }));
        json["ranges"].push_back(addTrack([&](const RecordedFrame& f) { return f.bodies[body].velocity.norm(); }));
        for (std::size_t word = 0; word < 3; ++word)
            for (const RecordedFrame* frame : frames_)
                tracks_.push_back(wordsOf(frame->bodies[body].pose.rotation)[word]);
    }

    /// A range's ends keep all their digits: every position depends on them.
    Json addTrack(const auto& valueIn) {
        std::vector<double> values;
        for (const RecordedFrame* frame : frames_) values.push_back(valueIn(*frame));
        const WordRange range = rangeOf(values);
        for (const double value : values) tracks_.push_back(range.wordOf(value));
        return {range.low, range.size};
    }

    /// The strongest contacts, in their own order; of the weakest equals the first ones.
    std::vector<engine::ContactState> contactsOf(const RecordedFrame& frame) const {
        const std::vector<engine::ContactState> all = pushing(frame);
        if (all.size() <= share_.contacts) return all;
        std::vector<double> impulses;
        for (const engine::ContactState& contact : all) impulses.push_back(contact.impulse);
        const auto last = impulses.begin() + static_cast<long>(share_.contacts) - 1;
        std::nth_element(impulses.begin(), last, impulses.end(), std::greater<>());
        const double least = *last;
        std::ptrdiff_t equals = std::count(impulses.begin(), last + 1, least);
        std::vector<engine::ContactState> kept;
        for (const engine::ContactState& contact : all)
            if (contact.impulse > least || (contact.impulse == least && equals-- > 0))
                kept.push_back(contact);
        return kept;
    }

    /// Columns: x, y, z, impulse, friction, direction of the normal, direction of friction.
    Json contacts() const {
        std::vector<engine::ContactState> all;
        Json counts = Json::array();
        for (const RecordedFrame* frame : frames_) {
            const std::vector<engine::ContactState> kept = contactsOf(*frame);
            counts.push_back(kept.size());
            all.insert(all.end(), kept.begin(), kept.end());
        }
        Words words;
        Json ranges = Json::array();
        const auto add = [&](const auto& valueOf) {
            std::vector<double> values;
            for (const engine::ContactState& contact : all) values.push_back(valueOf(contact));
            const WordRange range = rangeOf(values);
            for (const double value : values) words.push_back(range.wordOf(value));
            ranges.push_back({range.low, range.size});
        };
        for (int axis = 0; axis < 3; ++axis)
            add([axis](const engine::ContactState& c) { return c.position[axis]; });
        add([](const engine::ContactState& c) { return c.impulse; });
        add([](const engine::ContactState& c) { return c.friction.norm(); });
        for (const engine::ContactState& c : all) words.push_back(directionWord(c.normal));
        for (const engine::ContactState& c : all) words.push_back(directionWord(c.friction));
        return {{"counts", counts},
                {"ranges", ranges},
                {"words", textOfColumns(words, std::max<std::size_t>(all.size(), 1))}};
    }

    Json joints() const {
        Json list = Json::array();
        for (const RecordedJoint& joint : recording_.joints)
            list.push_back({{"name", joint.name},
                            {"a", joint.a},
                            {"b", joint.b},
                            {"atA", listOf(joint.atA)},
                            {"atB", listOf(joint.atB)},
                            {"until", (joint.frames - 1) / static_cast<int>(share_.every)}});
        return list;
    }

    Json bars() const {
        Json list = Json::array();
        for (const JointBar& bar : recording_.bars) {
            const bool ofJoint = bar.joint < static_cast<int>(recording_.joints.size());
            Json json{{"a", bar.a},
                      {"b", bar.b},
                      {"atA", listOf(bar.atA)},
                      {"atB", listOf(bar.atB)},
                      {"joint", ofJoint ? bar.joint : -1}};
            if (bar.rest >= 0.0)
                json["rest"] = shortOf(bar.rest);
            else
                json["radius"] = shortOf(bar.radius);
            list.push_back(std::move(json));
        }
        return list;
    }

    /// A single camera if it never moves.
    Json cameras() const {
        Json list = Json::array();
        for (const RecordedFrame* frame : frames_) {
            const render::Camera& c = frame->camera;
            list.push_back({{"from", listOf(c.from)},
                            {"at", listOf(c.lookAt)},
                            {"fov", shortOf(static_cast<double>(c.fovDegrees))},
                            {"shot", frame->shot}});
        }
        if (std::all_of(list.begin(), list.end(), [&](const Json& c) { return c == list[0]; }))
            list.erase(list.begin() + 1, list.end());
        return list;
    }

    Json curves() const {
        Json json;
        const auto add = [&](const char* name, const auto& valueIn) {
            json[name] = Json::array();
            for (const RecordedFrame* frame : frames_)
                json[name].push_back(shortOf(valueIn(*frame)));
        };
        using Frame = RecordedFrame;
        add("kinetic", [](const Frame& f) { return f.measures.energy.kinetic; });
        add("potential", [](const Frame& f) { return f.measures.energy.potential; });
        add("total", [](const Frame& f) { return f.measures.energy.total(); });
        add("penetration", [](const Frame& f) { return f.measures.penetration; });
        add("separation", [](const Frame& f) { return f.measures.separation; });
        add("peak", [](const Frame& f) { return f.impulsePeak; });
        return json;
    }

    const Recording& recording_;
    ReplayShare share_;
    std::vector<const RecordedFrame*> frames_;
    Meshes meshes_;
    Words tracks_;
};

}  // namespace

std::size_t mostContacts(const Recording& recording) {
    std::size_t most = 0;
    for (const RecordedFrame& frame : recording.frames)
        most = std::max(most, pushing(frame).size());
    return most;
}

Json replayJson(const Recording& recording, const ReplayShare& share) {
    return RunJson(recording, share).json();
}

}  // namespace demos
