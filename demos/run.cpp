#include "demos/run.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "demos/commands/commands.h"
#include "demos/own_files.h"
#include "demos/put_text.h"
#include "demos/scene/complaints.h"
#include "demos/scene/reader.h"
#include "render/error.h"

namespace demos {
namespace {

Exit perform(const Options& options) {
    spareScenes(options);
    switch (options.command) {
        case Command::render:
            return renderCommand(options);
        case Command::still:
            return stillCommand(options);
        case Command::strip:
            return stripCommand(options);
        case Command::sim:
            return simCommand(options);
        case Command::plot:
            return plotCommand(options);
        case Command::compare:
            return compareCommand(options);
        case Command::sweep:
            return sweepCommand(options);
        case Command::exports:
            return exportCommand(options);
        case Command::slides:
            return slidesCommand(options);
        case Command::test:
            return options.selfTest ? selfTestCommand(options) : testCommand(options);
        case Command::approve:
            return approveCommand(options);
        case Command::watch:
            return watchCommand(options);
        case Command::gallery:
            return galleryCommand(options);
        case Command::list:
            return listCommand(options);
        case Command::doctor:
            return doctorCommand(options);
        case Command::bench:
            return benchCommand(options);
        case Command::completion:
            return completionCommand(options);
    }
    return Exit::usage;
}

/// What is buffered may only fail to go out at the very end, as on a full disk.
Exit flushed(Exit code) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    throw render::Error("cannot write to standard output");
}

Exit tell(Exit code, const std::string& line) {
    putError(printable(line));
    return code;
}

Exit guarded(int argc, const char* const* argv) try {
    const std::optional<Options> options = parseOptions(argc, argv);
    return flushed(options ? perform(*options) : Exit::ok);
} catch (const Stop& stop) {
    return tell(stop.code(), stop.what());
} catch (const SceneError& error) {
    for (const std::string& line : error.lines()) tell(Exit::scene, line);
    return Exit::scene;
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
