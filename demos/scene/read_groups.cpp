// group = "wheels", ignores = ["chassis"]: names become bits

#include <algorithm>

#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

constexpr std::size_t kMostGroups = 32;

void collect(const BodyDescription& body, std::vector<std::string>& known,
             Complaints& complaints) {
    for (const std::string& name : body.groups) {
        if (known.size() > kMostGroups) return;
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        known.push_back(name);
        if (known.size() == kMostGroups + 1)
            complaints.add(body.place, "'" + name + "' is the 33rd group; there should be at most "
                                                    "32 in a scene");
    }
}

unsigned bitsOf(const std::vector<std::string>& names, const std::vector<std::string>& known) {
    unsigned bits = 0;
    for (const std::string& name : names) {
        const auto found = std::find(known.begin(), known.end(), name);
        const auto place = static_cast<std::size_t>(found - known.begin());
        if (place < std::min(known.size(), kMostGroups)) bits |= 1u << place;
    }
    return bits;
}

}  // namespace

void numberGroups(SceneDescription& scene, Complaints& complaints) {
    std::vector<std::string> known;
    for (const BodyDescription& body : scene.bodies) collect(body, known, complaints);
    Place complainedOf;  // one message for all turns of a [[repeat]]
    for (BodyDescription& body : scene.bodies) {
        body.def.groups = bitsOf(body.groups, known);
        body.def.ignores = bitsOf(body.ignores, known);
        for (const std::string& name : body.ignores) {
            const bool isKnown = std::find(known.begin(), known.end(), name) != known.end();
            const Place place = body.ignoresPlace;
            if (isKnown || (place.line == complainedOf.line && place.column == complainedOf.column))
                continue;
            complainedOf = place;
            complaints.add(place, "no body is in the group '" + name + "'" +
                                      (known.empty() ? "; write group = \"" + name + "\" in a body"
                                                     : suggestion(name, known)));
        }
    }
}

}  // namespace demos
