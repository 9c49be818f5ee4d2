/// What a picture shows besides the bodies.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct Overlays {
    bool contacts = false;  // a dot where a contact was solved
    bool normals = false;   // its normal
    bool impulses = false;  // what it got along the normal in the last step
    bool friction = false;  // and across
    bool nudges = false;    // where the last step's nudges moved each body
    bool joints = false;    // the two anchors of every joint
    bool axes = false;      // body axes: x red, y green, z blue
    bool com = false;       // centres of mass
    bool bounds = false;    // axis-aligned bounding boxes
    bool ids = false;       // the bodies' names
    bool ghost = false;     // earlier poses
    bool trails = true;     // of the bodies that the scene names
    bool text = true;       // time, bodies, solver, caption, legends
    bool headings = true;   // of the text: the first line and the caption
    bool clock = true;      // of the headings: the first line
    bool plate = false;     // the caption on a plate, where no line strikes it through
    bool stats = false;     // a panel of numbers in place of the first line
    bool plot = false;      // a strip below the picture, of a film of one scene
    std::string theme = "studio";
    std::string colorBy = "body";  // one of colorings()
    double colorMax = 0.0;         // the scale's end; 0: the largest so far
    double ghostEvery = 0.25;      // s
    double pixelsPerPoint = 0.0;   // of letters and lines on paper; 0: by the picture's size
};

/// Every name that --show takes.
const std::vector<std::string>& overlayNames();
/// "contacts normals ...", for help.
std::string overlayList();

/// Whether the named one is on; false for a name that is not known.
bool isOn(const Overlays& overlays, const std::string& name);

/// Switches the named ones on; false for a name that is not known.
bool switchOn(Overlays& overlays, const std::string& name);

/// What can decide about a body's colour.
const std::vector<std::string>& colorings();

}  // namespace demos
