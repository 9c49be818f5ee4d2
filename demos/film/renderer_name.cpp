#include "demos/film/renderer_name.h"

#include "demos/processes/own_process.h"
#include "render/renderer.h"

namespace demos {

std::string rendererName(const Options& options) {
    return inOwnProcess("the process that asks for OpenGL", [&] {
        render::RendererSettings settings;
        settings.width = settings.height = 16;
        settings.threads = 0;
        settings.reproducible = options.reproducible;
        settings.context = render::contextCalled(options.context);
        return render::Renderer(settings).describe();
    });
}

}  // namespace demos
