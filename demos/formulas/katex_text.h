/// KaTeX (Debian: libjs-katex), built in: one script that defines `katex`.
#pragma once
#include <string_view>

namespace demos {

std::string_view katexText();

}  // namespace demos
