/// Floors of several bodies, or of a compound's parts, that are flat together. What lies on one tile has sunk
/// in by its slop, and so meets the side of the next one: an edge that cannot be seen. With n and d of the
/// plane in which a body touches one tile, its contact with another one is left out where that tile
///   max n . x <= d      nowhere rises above the plane, and
///   |n . p - d| small   is met in it
/// or, if its own normal points the same way but for some degrees, gets n: it may hold the body up.
/// (A mesh's triangles know their neighbours: collide_convex.h.)
#pragma once
#include <vector>

#include "engine/constraints/contact.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class Seams {
public:
    /// Of contacts with fixed bodies, for the coming dt (s); the order of the others stays.
    void leaveOut(const Bodies& bodies, double dt, std::vector<Contact>& contacts);

private:
    struct Seat {
        int body = -1, contact = -1;  // the one that may move; the contact's place in the list
        auto operator<=>(const Seat&) const = default;
    };
    void look(const Bodies& bodies, double dt, std::vector<Contact>& contacts,
              std::size_t first, std::size_t end);

    std::vector<Seat> seats_;
    std::vector<char> hidden_;  // by contact
};

}  // namespace engine
