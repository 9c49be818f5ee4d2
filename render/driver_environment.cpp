#include "render/driver_environment.h"

#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace render {
namespace {

// By prefix, because Mesa adds and renames variables. Lower-case ones override entries of drirc.
constexpr std::string_view kPrefixes[] = {"DRAW_",    "DRIRC_",    "EGL_",  "GALLIUM_", "GALLIVM_",
                                          "GLSL_",    "LIBGL_",    "LP_",   "MESA_",    "NIR_",
                                          "OSMESA_",  "SOFTPIPE_", "ST_",   "TGSI_",    "allow_",
                                          "disable_", "force_",    "glsl_", "mesa_"};

/// The places of files depend on the installation. The cache of compiled shaders changes no pixel,
/// because the processor's features and GALLIVM_PERF are part of its keys. It saves a process a
/// second of CPU.
constexpr std::string_view kKept[] = {"LIBGL_DRIVERS_PATH", "MESA_SHADER_CACHE_DIR",
                                      "MESA_SHADER_CACHE_DISABLE", "MESA_SHADER_CACHE_MAX_SIZE"};

std::vector<std::string> driverVariables() {
    std::vector<std::string> names;
    for (char** entry = environ; entry && *entry; ++entry) {
        const std::string_view text = *entry;
        const std::string_view name = text.substr(0, text.find('='));
        if (isDriverVariable(name)) names.emplace_back(name);
    }
    return names;
}

}  // namespace

bool isDriverVariable(std::string_view name) {
    for (const std::string_view kept : kKept)
        if (name == kept) return false;
    for (const std::string_view prefix : kPrefixes)
        if (name.starts_with(prefix)) return true;
    return false;
}

void prepareDriverEnvironment(const ContextSettings& settings) {
    for (const std::string& name : driverVariables()) unsetenv(name.c_str());
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // EGL would use a graphics card, with other pixels
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);  // else EGL chooses among the software drivers
    if (settings.threads >= 0)
        setenv("LP_NUM_THREADS", std::to_string(settings.threads).c_str(), 1);
    if (!settings.reproducible) return;
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);  // no FMA: both classes give the same pixels
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
}

const char* pixelClass(bool reproducible) {
    if (reproducible) return "reproducible";
#if defined(__x86_64__) || defined(__i386__)
    return __builtin_cpu_supports("fma") ? "fma" : "no fma";
#else
    return "fma";
#endif
}

}  // namespace render
