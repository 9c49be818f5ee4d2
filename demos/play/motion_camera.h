/// The camera of a scene that does not place its own: it sees the motion of the whole run.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// Sets `from` and `lookAt` of the scenes whose camera fits the motion; all of them get the same,
/// so that variants can be compared. The box around all bodies that move, over the whole run,
/// then fills 70 % of a picture of 16:9. Planes and large fixed bodies do not count, nor do bodies
/// while they are far away from most others. Costs one run of each such scene, without pictures;
/// scenes that place their camera cost nothing.
void fitToMotion(std::span<SceneDescription* const> scenes);

/// Where bodies are at times of a run, and what stands still.
struct RunMotion {
    struct Sample {
        const BodyDescription* body = nullptr;
        int number = 0;  // of the body
        engine::Pose pose;
        bool first = false;  // before the first step

        const engine::Shape& shape() const { return body->def.shape; }
    };
    std::vector<Sample> moving, fixed;
    std::vector<Vec3> anchors;  // m, of joints to the world
};

/// The same for one scene, from a run that is made anyway.
class MotionSampler {
public:
    /// `scene` must outlive it. `scenes`: whose cameras are fitted together.
    explicit MotionSampler(const SceneDescription& scene, std::size_t scenes = 1);
    /// To be called before the first step and after every one.
    void look(const Stage& stage, long step);
    const RunMotion& motion() const { return motion_; }
    /// After the run: the scene's camera, with `from` and `lookAt` set.
    CameraDescription camera() const;

private:
    const SceneDescription& scene_;
    long every_;                // steps between two samples
    Vec3 start_ = Vec3::Zero();  // m, the middle before the first step
    RunMotion motion_;
};

/// m: the median, along each axis, of the places of the bodies that are not fixed; nothing if there
/// are none.
std::optional<Vec3> middleOf(const Stage& stage);

}  // namespace demos
