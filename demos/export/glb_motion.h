/// The animation of a .glb: the poses of nodes at the times of the frames.
#pragma once
#include <vector>

#include "demos/export/glb_buffer.h"
#include "engine/base/math.h"

namespace demos {

/// A pose as in the file: floats, the rotation (x, y, z, w) of length 1.
struct GlbPose {
    Eigen::Vector3f translation{0, 0, 0};  // m
    Eigen::Vector4f rotation{0, 0, 0, 1};
};
GlbPose glbPoseOf(const engine::Pose& pose);

class GlbMotion {
public:
    /// `times`: s, ascending; for every channel.
    GlbMotion(std::vector<float> times, GlbBuffer& buffer)
        : times_(std::move(times)), buffer_(buffer) {}

    /// A node's pose at every time. A value that does not change gets no channel.
    void add(int node, std::vector<GlbPose> poses);
    /// Its scale, likewise.
    void addScales(int node, const std::vector<Eigen::Vector3f>& scales);
    /// A file's `animations`; empty if nothing moves.
    GlbJson animations() const;

private:
    void addChannel(int node, const char* path, const std::vector<float>& values, GlbType type);

    std::vector<float> times_;
    GlbBuffer& buffer_;
    int timesAccessor_ = -1;  // none before the first channel
    GlbJson samplers_ = GlbJson::array(), channels_ = GlbJson::array();
};

}  // namespace demos
