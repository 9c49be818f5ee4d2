#include "demos/program/run.h"
#include "demos/program/parse.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>

#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/put_text.h"
#include "render/error.h"

namespace demos {
namespace {

/// Writing buffered output can fail as late as here, for example on a full disk.
Exit flushed(Exit code) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    throw render::Error("cannot write to standard output");
}

Exit tell(Exit code, const std::string& line) {
    putError(shown(printable(line), kLongestMessage));
    return code;
}

Exit guarded(int argc, const char* const* argv) try {
    const auto todo = parse(argc, argv);
    return flushed(todo ? (*todo)() : Exit::ok);
} catch (const Stop& stop) {
    return tell(stop.code(), stop.what());
} catch (const SceneError& error) {
    for (const std::string& line : error.lines()) tell(Exit::scene, line);
    return Exit::scene;
} catch (const render::AlreadyThere& there) {
    return tell(Exit::wouldOverwrite, there.what());
} catch (const std::bad_alloc&) {
    return tell(Exit::environment, "not enough memory");
} catch (const std::filesystem::filesystem_error& error) {
    return tell(Exit::environment,
                "cannot use '" + shown(error.path1().string(), 200) + "': " + error.code().message());
} catch (const std::exception& error) {  // render::Error, and what a library throws
    return tell(Exit::environment, error.what());
}

/// No memory in a function that must not throw, as there are in the parser's library.
[[noreturn]] void endWithoutMemory() noexcept {
    try {
        const std::exception_ptr error = std::current_exception();
        if (error) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        constexpr std::string_view kLine = "impulse: not enough memory\n";
        [[maybe_unused]] const auto told = write(STDERR_FILENO, kLine.data(), kLine.size());
        _exit(static_cast<int>(Exit::environment));
    } catch (...) {
    }
    std::abort();
}

}  // namespace

int run(int argc, const char* const* argv) noexcept {
    std::set_terminate(endWithoutMemory);
    const Exit code = guarded(argc, argv);
    std::fflush(stdout);
    return static_cast<int>(code);
}

}  // namespace demos
