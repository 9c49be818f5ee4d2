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

/// Opens closed standard streams so that they refuse all access. Otherwise the next file that is
/// opened would get such a stream's number, and messages to the user would go into it.
static void fillStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1)
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// Lets the program keep freed memory. A frame's buffers are some megabytes each and are allocated
/// again for every frame; memory returned to the system would be cleared each time.
static void keepBuffers() {
#if defined(__GLIBC__)
    constexpr int kMost = 32 << 20;  // bytes, glibc's maximum
    mallopt(M_MMAP_THRESHOLD, kMost);
    mallopt(M_TRIM_THRESHOLD, 4 * kMost);
#endif
}

int main(int argc, char** argv) {
    fillStandardStreams();
    keepBuffers();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe becomes an error that is reported
    std::signal(SIGXFSZ, SIG_IGN);  // and so does a file at its size limit
    std::fesetround(FE_TONEAREST);
#if defined(__SSE__)
    _mm_setcsr(0x1f80);  // the default: no flush-to-zero, whatever a library's start-up has set
#endif
    return demos::run(argc, argv);
}
