#include "engine/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace engine {

void checkFailed(const char* condition, const char* advice, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: check failed: %s; %s\n", file, line, condition, advice);
    std::abort();
}

}  // namespace engine
