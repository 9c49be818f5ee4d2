#include "demos/look/overlays.h"

namespace demos {
namespace {

struct Switch {
    const char* name;
    bool Overlays::*member;
};
constexpr Switch kSwitches[] = {
    {"contacts", &Overlays::contacts}, {"normals", &Overlays::normals},
    {"impulses", &Overlays::impulses}, {"friction", &Overlays::friction},
    {"nudges", &Overlays::nudges},     {"annotate", &Overlays::annotate},
    {"joints", &Overlays::joints},     {"axes", &Overlays::axes},
    {"com", &Overlays::com},           {"bounds", &Overlays::bounds},
    {"ids", &Overlays::ids},           {"ghost", &Overlays::ghost},
    {"trails", &Overlays::trails},     {"caption", &Overlays::text},
    {"stats", &Overlays::stats},       {"plot", &Overlays::plot},
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

std::string overlayList() {
    std::string list;
    for (const std::string& name : overlayNames()) list += (list.empty() ? "" : " ") + name;
    return list;
}

const std::vector<std::string>& colorings() {
    static const std::vector<std::string> names = {"body",  "speed",    "impulse", "island",
                                                   "group", "material", "id"};
    return names;
}

bool isOn(const Overlays& overlays, const std::string& name) {
    for (const Switch& s : kSwitches)
        if (name == s.name) return overlays.*s.member;
    return false;
}

bool switchOn(Overlays& overlays, const std::string& name) {
    for (const Switch& s : kSwitches)
        if (name == s.name) return overlays.*s.member = true;
    return false;
}

}  // namespace demos
