/// A run of known contents, for tests of replay.html.
#pragma once
#include <cmath>
#include <string>

#include "demos/export/recording.h"

namespace support {

inline demos::RecordedBody plantedBall(const std::string& name, double radius) {
    demos::DrawnPart part;
    part.solid.shape = render::SolidShape::sphere;
    part.solid.halfSize.setConstant(static_cast<float>(radius));
    return {name, {0.9f, 0.1f, 0.1f, 1.0f}, render::Material::plastic, {part}, {0, 0, 0}, 2.0};
}

/// The pose of ball number `body` at a time (s): on its own orbit, 30 m across, and turning.
inline engine::Pose plantedPose(int body, double time) {
    engine::Pose pose;
    pose.position = {15.0 * std::sin(time + body), 15.0 * std::cos(0.7 * time), 3.0 * body};
    const engine::Vec3 axis(1.0, 0.3 * body, std::sin(0.4 * time));
    pose.rotation = Eigen::AngleAxisd(2.1 * time + body, axis.normalized());
    return pose;
}

inline demos::RecordedFrame plantedFrame(int bodies, int contacts, double time) {
    demos::RecordedFrame frame;
    for (int i = 0; i < bodies; ++i)
        frame.bodies.push_back({plantedPose(i, time), {2.0 + std::sin(time * i), 0, 0}, {0, 0, 0}});
    for (int i = 0; i < contacts; ++i) {
        engine::ContactState& contact = frame.contacts.emplace_back();
        contact.position = {std::sin(31.0 * time + i), 0.0, std::cos(17.0 * time * i)};
        contact.normal = {0.0, 1.0, 0.0};
        contact.impulse = 1.0 + std::fmod(0.6180339887 * i + time, 1.0);
        contact.friction = {0.1 * std::sin(7.0 * i), 0.0, 0.2};
    }
    frame.measures.energy.kinetic = 10.0 + std::sin(time);
    frame.measures.energy.potential = -5.0 * std::cos(time);
    frame.measures.penetration = 1e-4 * (1.0 + std::sin(3.0 * time));
    frame.camera.from = {0, 5, 40};
    frame.camera.lookAt = {0, 0, 0};
    frame.impulsePeak = 2.0;
    return frame;
}

inline demos::Recording plantedRecording(int bodies, int frames, int contacts) {
    demos::Recording recording;
    recording.name = "planted";
    recording.title = "Balls on orbits";
    recording.seconds = (frames - 1) / recording.framesASecond;
    recording.viewHeight = 25.0;
    recording.thinnest = 0.5;
    for (int i = 0; i < bodies; ++i)
        recording.bodies.push_back(plantedBall("ball" + std::to_string(i), 0.5));
    for (int frame = 0; frame < frames; ++frame)
        recording.frames.push_back(
            plantedFrame(bodies, frame > 0 ? contacts : 0, frame / recording.framesASecond));
    return recording;
}

}  // namespace support
