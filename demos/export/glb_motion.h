/// The animation of a .glb: where nodes are at the times of the frames.
#pragma once
#include <vector>

#include "demos/export/glb_buffer.h"
#include "engine/base/math.h"

namespace demos {

/// What a file says of a place: floats, the rotation (x, y, z, w) of length 1.
struct GlbPose {
    Eigen::Vector3f translation{0, 0, 0};  // m
    Eigen::Vector4f rotation{0, 0, 0, 1};
};
GlbPose glbPoseOf(const engine::Pose& pose);

class GlbMotion {
public:
    /// `times`: s, rising; of every channel.
    GlbMotion(std::vector<float> times, GlbBuffer& buffer)
        : times_(std::move(times)), buffer_(buffer) {}

    /// Where a node is at every time. What stays as it is gets no channel.
    void add(int node, std::vector<GlbPose> poses);
    /// How large it is, likewise.
    void addScales(int node, const std::vector<Eigen::Vector3f>& scales);
    /// A file's `animations`; empty where nothing moves.
    GlbJson animations() const;

private:
    void addChannel(int node, const char* path, const std::vector<float>& values, GlbType type);

    std::vector<float> times_;
    GlbBuffer& buffer_;
    int timesAccessor_ = -1;  // none before the first channel
    GlbJson samplers_ = GlbJson::array(), channels_ = GlbJson::array();
};

}  // namespace demos
