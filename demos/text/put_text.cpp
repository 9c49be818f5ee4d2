#include "demos/text/put_text.h"

#include <fmt/format.h>

namespace demos {

void putText(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);  // the stream remembers a failure
}

void putError(std::string_view line) { putText(stderr, fmt::format("impulse: {}\n", line)); }

}  // namespace demos
