/// A 64-bit hash of a frame: frames with the same hash are drawn alike.
#pragma once
#include <cstdint>
#include <map>
#include <memory>

#include "render/frame.h"

namespace demos {

/// Hashes the frames of one run; a mesh that many of them share is hashed once.
class FrameHasher {
public:
    /// The hash of all values in the frame. Two frames that differ have the same hash with a chance
    /// of 2^-64.
    std::uint64_t of(const render::Frame& frame);

private:
    std::uint64_t of(const std::shared_ptr<const render::SolidMesh>& mesh);

    // Owned, so that no other mesh gets a known address.
    std::map<std::shared_ptr<const render::SolidMesh>, std::uint64_t> meshes_;
};

}  // namespace demos
