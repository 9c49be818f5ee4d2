/// printf into a string of at most 255 characters.
#pragma once
#include <cstdio>
#include <string>

namespace peers {

template <class... Arguments>
std::string text(const char* format, Arguments... arguments) {
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, arguments...);
    return buffer;
}

}  // namespace peers
