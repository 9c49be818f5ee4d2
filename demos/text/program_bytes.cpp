#include "demos/text/program_bytes.h"

#include <cstdio>
#include <string_view>

#include "demos/text/hex_text.h"
#include "demos/text/text_hash.h"
#include "demos/text/version.h"

namespace demos {
namespace {

std::uint64_t hashOfProgram() {
    TextHash hash;
    if (std::FILE* file = std::fopen("/proc/self/exe", "rb")) {
        char block[65536];
        for (std::size_t got; (got = std::fread(block, 1, sizeof block, file)) > 0;)
            hash.add(std::string_view(block, got));
        std::fclose(file);
    }
    return hash.value();
}

}  // namespace

std::uint64_t programHash() {
    static const std::uint64_t known = hashOfProgram();
    return known;
}

std::string programName() { return std::string(kVersion) + " " + hexText(programHash()); }

}  // namespace demos
