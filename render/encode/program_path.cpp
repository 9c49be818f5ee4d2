#include "render/encode/program_path.h"

#include <unistd.h>

#include <cstdlib>

namespace render {

std::optional<std::filesystem::path> programPath(std::string_view name) {
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable ? variable : "/bin:/usr/bin";
    while (true) {
        const std::size_t colon = folders.find(':');
        const std::filesystem::path folder =
            colon == 0 || folders.empty() ? "." : folders.substr(0, colon);
        const std::filesystem::path program = folder / name;
        std::error_code ignored;
        if (::access(program.c_str(), X_OK) == 0 &&
            std::filesystem::is_regular_file(program, ignored)) {
            return program;
        }
        if (colon == std::string_view::npos) return std::nullopt;
        folders.remove_prefix(colon + 1);
    }
}

}  // namespace render
