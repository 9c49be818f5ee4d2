#include "demos/put_text.h"

namespace demos {

void putText(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);  // the stream keeps in mind that it failed
}

}  // namespace demos
