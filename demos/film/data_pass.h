/// The passes of --pass: data written next to a film's pictures, one file per frame and pass.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace demos {

enum class Pass { depth, depth16, normal, id, flow, camera, poses, contacts, events };

struct PassText {
    Pass pass;
    const char* name;    // also the name of its folder
    const char* ending;  // of a file's name
    const char* format;
    const char* unit;
    const char* about;  // what a value means, and special values
};

/// Every pass, in the order in which their files are made.
std::span<const PassText> passTexts();
const PassText& textOf(Pass pass);
std::vector<std::string> passNames();

/// Each once, in the order of passTexts(); `names` must be names of passes.
std::vector<Pass> passesCalled(const std::vector<std::string>& names);

std::vector<std::string> passNamesOf(const std::vector<Pass>& passes);

}  // namespace demos
