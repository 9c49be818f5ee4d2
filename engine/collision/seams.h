/// Floors made of several bodies, or of a compound's parts, that form one plane. A body resting on one tile
/// has sunk in by the slop, and so meets the side of the next tile, an edge that is not really there. With n
/// and d of the plane in which a body touches one tile, its contact with another is left out where that tile
///   max n . x <= d      nowhere rises above the plane, and
///   |n . p - d| small   is touched in the plane
/// or, if its own normal differs by some degrees only, gets n, because it may help to support the body. (A
/// mesh's triangles know their neighbours: collide_convex.h.)
#pragma once
#include <vector>

#include "engine/constraints/contact.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class Seams {
public:
    /// Leaves out contacts with fixed bodies, for the coming dt (s); keeps the order of the rest.
    void leaveOut(const Bodies& bodies, double dt, std::vector<Contact>& contacts);

private:
    struct Seat {
        int body = -1, contact = -1;  // the moving body; the contact's index
        auto operator<=>(const Seat&) const = default;
    };
    void look(const Bodies& bodies, double dt, std::vector<Contact>& contacts,
              std::size_t first, std::size_t end);

    std::vector<Seat> seats_;
    std::vector<char> hidden_;  // by contact
};

}  // namespace engine
