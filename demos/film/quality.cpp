#include "demos/film/quality.h"

namespace demos {
namespace {

using render::Finish;

constexpr Quality kQualities[] = {
    {"draft", 480, 270, 15, 1, 1, Finish::draft},
    {"low", 854, 480, 30, 8, 1, Finish::standard},
    {"medium", 1280, 720, 30, 8, 1, Finish::standard},
    {"high", 1920, 1080, 60, 8, 1, Finish::standard},
    {"4k", 3840, 2160, 60, 8, 1, Finish::standard},
    {"film", 1280, 720, 30, 1, 12, Finish::standard},
};

}  // namespace

const std::vector<std::string>& qualityNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Quality& quality : kQualities) all.emplace_back(quality.name);
        return all;
    }();
    return names;
}

const Quality& qualityOf(const std::string& name) {
    for (const Quality& quality : kQualities)
        if (name == quality.name) return quality;
    return kQualities[2];
}

}  // namespace demos
