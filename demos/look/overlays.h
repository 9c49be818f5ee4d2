/// What a picture shows in addition to the bodies.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct Overlays {
    bool contacts = false;  // a dot where a contact was solved
    bool normals = false;   // its normal
    bool impulses = false;  // its impulse along the normal in the last step
    bool friction = false;  // and its friction impulse
    bool nudges = false;    // where the last step's nudges moved each body
    bool annotate = false;  // names of the vectors of one contact or joint
    bool joints = false;    // the two anchors of every joint
    bool axes = false;      // body axes: x red, y green, z blue
    bool com = false;       // centres of mass
    bool bounds = false;    // axis-aligned bounding boxes
    bool ids = false;       // the bodies' names
    bool ghost = false;     // earlier poses
    bool trails = true;     // of the bodies named by the scene
    bool text = true;       // caption, legends
    bool headings = true;   // part of the text: the caption
    bool stats = false;     // a panel of numbers; on paper a line, if the panel has no room
    bool clock = true;      // part of the statistics: that line
    bool plot = false;      // a strip of charts below the picture, in a film of one scene
    std::string theme = "studio";
    std::string colorBy = "body";  // one of colorings()
    double colorMax = 0.0;         // end of the scale; 0: the largest value so far
    double ghostEvery = 0.25;      // s
    double pixelsPerPoint = 0.0;   // for letters and lines on paper; 0: by the picture's size
};

/// All names for --show.
const std::vector<std::string>& overlayNames();
/// "contacts normals ...", for help.
std::string overlayList();

/// Whether the named overlay is on; false for an unknown name.
bool isOn(const Overlays& overlays, const std::string& name);

/// Switches the named overlay on; false for an unknown name.
bool switchOn(Overlays& overlays, const std::string& name);

/// All names for --colour-by.
const std::vector<std::string>& colorings();

}  // namespace demos
