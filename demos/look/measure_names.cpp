#include "demos/look/measure_names.h"

namespace demos {

const std::vector<std::string>& measureNames() {
    static const std::vector<std::string> names = {"energy",   "penetration", "separation",
                                                   "contacts", "impulse",     "residual"};
    return names;
}

}  // namespace demos
