#include <fcntl.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <initializer_list>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "demos/run.h"

/// A closed standard stream would give its number to the next file that is opened, and what is
/// meant for the user would be written there. One that refuses takes its place.
static void fillStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1)
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char** argv) {
    fillStandardStreams();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error to be told, not a death
    std::signal(SIGXFSZ, SIG_IGN);  // so is a file that may not grow
    std::fesetround(FE_TONEAREST);
#if defined(__SSE__)
    _mm_setcsr(0x1f80);  // the default: no flush-to-zero, whatever a library's start-up has set
#endif
    return demos::run(argc, argv);
}
