#include "demos/text/escaped_path.h"

#include <fmt/format.h>

#include <string_view>

namespace demos {

std::string escapedPath(const std::string& path) {
    constexpr std::string_view kUnescaped =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~/";
    std::string text;
    for (const char c : path)
        if (kUnescaped.find(c) != std::string_view::npos)
            text += c;
        else
            text += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return text;
}

}  // namespace demos
