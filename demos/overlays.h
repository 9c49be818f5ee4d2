/// What a picture shows besides the bodies.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct Overlays {
    bool contacts = false;  // a dot where a contact was solved
    bool normals = false;   // its normal, 0.3 m long
    bool impulses = false;  // what it got along the normal in the last step
    bool friction = false;  // and across
    bool nudges = false;    // where the last step's nudges moved each body
    bool joints = false;    // the two anchors of every joint
    bool axes = false;      // body axes
    bool trails = true;     // of the bodies that the scene names
    bool text = true;       // time, bodies, solver, caption
    bool stats = false;     // contacts, penetration, energy
    std::string theme = "studio";
};

/// Every name that --show takes.
const std::vector<std::string>& overlayNames();

/// Switches the named ones on; false for a name that is not known (or not drawn).
bool switchOn(Overlays& overlays, const std::string& name);

}  // namespace demos
