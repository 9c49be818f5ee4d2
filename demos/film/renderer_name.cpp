#include "demos/film/renderer_name.h"

#include "demos/processes/process_pool.h"
#include "render/renderer.h"

namespace demos {

std::string rendererName(const Options& options) {
    std::string name, problem;
    const auto ask = [&options](int) -> std::string {
        try {
            render::RendererSettings settings;
            settings.width = settings.height = 16;
            settings.threads = 0;
            settings.reproducible = options.reproducible;
            settings.context = render::contextCalled(options.context);
            return "+" + render::Renderer(settings).describe();
        } catch (const std::exception& error) {
            return std::string("-") + error.what();
        }
    };
    runInProcesses(1, 1, ask, [&](int, const PoolResult& result) {
        const bool good = result.ended && result.text.starts_with('+');
        (good ? name : problem) = result.ended ? result.text.substr(1)
                                               : "the process that asks for OpenGL " + result.text;
    });
    if (!problem.empty()) throw render::Error(problem);
    return name;
}

}  // namespace demos
