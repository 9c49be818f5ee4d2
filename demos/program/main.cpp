#include <fcntl.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <string>

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

/// Starts the program once more with large pages for its buffers (transparent huge pages), which glibc can be
/// asked for only by the environment. A cold picture has 60 MB of buffers, and their small pages took half of
/// its time. Nothing is done where the user has set GLIBC_TUNABLES, or the system does not leave it to programs.
static void useLargePages([[maybe_unused]] char** argv) {
#if defined(__GLIBC__)
    constexpr const char* kTunables = "GLIBC_TUNABLES";
    if (std::getenv(kTunables) != nullptr) return;
    std::string choices;
    std::getline(std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"), choices);
    char self[4096];
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (choices.find("[madvise]") == std::string::npos || length <= 0) return;
    self[length] = '\0';
    setenv(kTunables, "glibc.malloc.hugetlb=1", 1);
    execv(self, argv);  // returns only if it fails; then without them
#endif
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
    useLargePages(argv);
    keepBuffers();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe becomes an error that is reported
    std::signal(SIGXFSZ, SIG_IGN);  // and so does a file at its size limit
    std::fesetround(FE_TONEAREST);
#if defined(__SSE__)
    _mm_setcsr(0x1f80);  // the default: no flush-to-zero, whatever a library's start-up has set
#endif
    return demos::run(argc, argv);
}
