#include <fcntl.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <initializer_list>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "demos/program/run.h"

/// A closed standard stream would give its number to the next file that is opened, and what is
/// meant for the user would be written there. One that refuses takes its place.
static void fillStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1)
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// A frame's buffers are some megabytes each and come again with every frame: kept by the program,
/// they are not cleared by the system again each time.
static void keepBuffers() {
#if defined(__GLIBC__)
    constexpr int kMost = 32 << 20;  // bytes, the most that glibc takes
    mallopt(M_MMAP_THRESHOLD, kMost);
    mallopt(M_TRIM_THRESHOLD, 4 * kMost);
#endif
}

int main(int argc, char** argv) {
    fillStandardStreams();
    keepBuffers();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error to be reported, not a death
    std::signal(SIGXFSZ, SIG_IGN);  // so is a file that may not grow
    std::fesetround(FE_TONEAREST);
#if defined(__SSE__)
    _mm_setcsr(0x1f80);  // the default: no flush-to-zero, whatever a library's start-up has set
#endif
    return demos::run(argc, argv);
}
