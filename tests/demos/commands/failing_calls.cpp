// A library to load before all others (LD_PRELOAD): it lets the n-th call of a function fail,
// counted over all processes of a run of `impulse`. Programs that it starts, such as ffmpeg, are
// left alone.
//   IMPULSE_FAIL_CALL   the function: write, rename, fork, malloc, ...
//   IMPULSE_FAIL_AT     n, from 1; 0: none fails, they are only counted
//   IMPULSE_FAIL_ERRNO  the error
//   IMPULSE_FAIL_COUNT  a file of at least 8 bytes that holds the number of calls
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

extern "C" void* __libc_malloc(size_t);
extern "C" void* __libc_calloc(size_t, size_t);
extern "C" void* __libc_realloc(void*, size_t);

// flock, the function, has the name of a structure too.
#pragma GCC diagnostic ignored "-Wshadow"

namespace {

const char* failing = nullptr;  // nullptr: another program, or not yet
long failsAt = 0;
int failsWith = EIO;
std::atomic<long>* calls = nullptr;  // in memory that all processes of the run share

long numberOf(const char* name, long otherwise) {
    const char* text = getenv(name);
    return text ? atol(text) : otherwise;
}

/// Only with system calls: nothing here may count itself.
__attribute__((constructor)) void begin() {
    const char* count = getenv("IMPULSE_FAIL_COUNT");
    if (!count || strcmp(program_invocation_short_name, "impulse") != 0) return;
    const long file = syscall(SYS_openat, AT_FDCWD, count, O_RDWR | O_CLOEXEC, 0);
    if (file < 0) return;
    const long at = syscall(SYS_mmap, nullptr, 4096L, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0L);
    syscall(SYS_close, file);
    if (at == -1) return;
    calls = reinterpret_cast<std::atomic<long>*>(at);
    failsAt = numberOf("IMPULSE_FAIL_AT", 0);
    failsWith = static_cast<int>(numberOf("IMPULSE_FAIL_ERRNO", EIO));
    failing = getenv("IMPULSE_FAIL_CALL");
}

bool fails(const char* name) {
    if (!failing || strcmp(failing, name) != 0) return false;
    if (++*calls != failsAt) return false;
    errno = failsWith;
    return true;
}

/// The function of this name in the library behind this one.
template <class Function>
Function* behind(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#define FAILS_WITH_MINUS_1(result, name, parameters, ...)        \
    extern "C" result name parameters {                          \
        if (fails(#name)) return -1;                             \
        static auto* const real = behind<result parameters>(#name); \
        return real(__VA_ARGS__);                                \
    }

FAILS_WITH_MINUS_1(ssize_t, write, (int file, const void* bytes, size_t n), file, bytes, n)
FAILS_WITH_MINUS_1(ssize_t, read, (int file, void* bytes, size_t n), file, bytes, n)
FAILS_WITH_MINUS_1(ssize_t, send, (int to, const void* bytes, size_t n, int flags), to, bytes, n,
                   flags)
FAILS_WITH_MINUS_1(int, rename, (const char* from, const char* to), from, to)
FAILS_WITH_MINUS_1(int, renameat2,
                   (int a, const char* from, int b, const char* to, unsigned flags), a, from, b, to,
                   flags)
FAILS_WITH_MINUS_1(int, flock, (int file, int how), file, how)
FAILS_WITH_MINUS_1(int, mkdir, (const char* name, mode_t mode), name, mode)
FAILS_WITH_MINUS_1(int, socketpair, (int domain, int type, int protocol, int* pair), domain, type,
                   protocol, pair)
FAILS_WITH_MINUS_1(int, pipe2, (int* ends, int flags), ends, flags)
FAILS_WITH_MINUS_1(int, memfd_create, (const char* name, unsigned flags), name, flags)
FAILS_WITH_MINUS_1(pid_t, fork, ())

extern "C" int open(const char* name, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = va_arg(more, mode_t);
    va_end(more);
    return fails("open") ? -1 : openat(AT_FDCWD, name, flags, mode);
}

/// A close that fails has closed the file all the same.
extern "C" int close(int file) {
    const long result = syscall(SYS_close, file);
    return fails("close") ? -1 : static_cast<int>(result);
}

extern "C" int posix_spawnp(pid_t* process, const char* program,
                            const posix_spawn_file_actions_t* files,
                            const posix_spawnattr_t* attributes,
                            char* const* arguments, char* const* environment) {
    if (fails("posix_spawnp")) return errno;
    static auto* const real = behind<decltype(posix_spawnp)>("posix_spawnp");
    return real(process, program, files, attributes, arguments, environment);
}

extern "C" void* malloc(size_t n) { return fails("malloc") ? nullptr : __libc_malloc(n); }
extern "C" void* calloc(size_t count, size_t n) {
    return fails("malloc") ? nullptr : __libc_calloc(count, n);
}
extern "C" void* realloc(void* old, size_t n) {
    return fails("malloc") ? nullptr : __libc_realloc(old, n);
}
