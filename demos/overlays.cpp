#include "demos/overlays.h"

namespace demos {
namespace {

struct Switch {
    const char* name;
    bool Overlays::*member;
};
constexpr Switch kSwitches[] = {
    {"contacts", &Overlays::contacts}, {"normals", &Overlays::normals},
    {"impulses", &Overlays::impulses}, {"friction", &Overlays::friction},
    {"nudges", &Overlays::nudges},     {"joints", &Overlays::joints},
    {"axes", &Overlays::axes},         {"trails", &Overlays::trails},
    {"caption", &Overlays::text},      {"stats", &Overlays::stats},
};

}  // namespace

const std::vector<std::string>& overlayNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Switch& s : kSwitches) all.emplace_back(s.name);
        return all;
    }();
    return names;
}

bool switchOn(Overlays& overlays, const std::string& name) {
    for (const Switch& s : kSwitches)
        if (name == s.name) return overlays.*s.member = true;
    return false;
}

}  // namespace demos
