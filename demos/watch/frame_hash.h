/// Whether two frames would be drawn alike, by a number of 64 bits.
#pragma once
#include <cstdint>
#include <map>
#include <memory>

#include "render/frame.h"

namespace demos {

/// The frames of one run: a mesh that many of them share is looked at once.
class FrameHasher {
public:
    /// Of everything that the frame holds, by value. Two frames that differ have the same number
    /// with a chance of 2^-64.
    std::uint64_t of(const render::Frame& frame);

private:
    std::uint64_t of(const std::shared_ptr<const render::SolidMesh>& mesh);

    // Held, so that no other mesh comes to a known address.
    std::map<std::shared_ptr<const render::SolidMesh>, std::uint64_t> meshes_;
};

}  // namespace demos
