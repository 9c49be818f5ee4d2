#include "demos/program/run.h"
#include "demos/program/parse.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>

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
    putError(printable(line));
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
} catch (const std::exception& error) {  // render::Error, and what a library throws
    return tell(Exit::environment, error.what());
}

}  // namespace

int run(int argc, const char* const* argv) noexcept {
    const Exit code = guarded(argc, argv);
    std::fflush(stdout);
    return static_cast<int>(code);
}

}  // namespace demos
