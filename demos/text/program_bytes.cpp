#include "demos/text/program_bytes.h"

#include <cstdio>
#include <string_view>

#include "demos/text/hex_text.h"
#include "demos/text/version.h"

namespace demos {

void addProgram(TextHash& hash) {
    if (std::FILE* file = std::fopen("/proc/self/exe", "rb")) {
        char block[65536];
        for (std::size_t got; (got = std::fread(block, 1, sizeof block, file)) > 0;)
            hash.add(std::string_view(block, got));
        std::fclose(file);
    }
}

std::string programName() {
    TextHash hash;
    addProgram(hash);
    return std::string(kVersion) + " " + hexText(hash.value());
}

}  // namespace demos
