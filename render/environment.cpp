#include "render/environment.h"

#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/error.h"

extern char** environ;

namespace render {
namespace {

bool steersMesa(std::string_view name) {
    return name.starts_with("LP_") || name.starts_with("GALLIUM_") ||
           name.starts_with("GALLIVM_") || name == "DRAW_USE_LLVM";
}

void clearDriverVariables() {
    std::vector<std::string> names;
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string_view text{*entry};
        const std::string_view name = text.substr(0, text.find('='));
        if (steersMesa(name)) names.emplace_back(name);
    }
    for (const std::string& name : names) unsetenv(name.c_str());
}

struct DriverChoice {
    bool reproducible;
    int threads;
    bool operator==(const DriverChoice&) const = default;
};

void setDriverVariables(const DriverChoice& choice) {
    clearDriverVariables();
    if (choice.reproducible) {
        // Without FMA, four lanes: every x86-64 CPU since 2008 then draws the same bits.
        setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
        setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
    }
    if (choice.threads >= 0) setenv("LP_NUM_THREADS", std::to_string(choice.threads).c_str(), 1);
}

}  // namespace

void prepareEnvironment(const RendererSettings& settings) {
    static std::mutex mutex;
    static std::optional<DriverChoice> first;
    const std::lock_guard lock(mutex);
    const DriverChoice wanted{settings.reproducible, settings.threads};
    if (!first) {
        setDriverVariables(wanted);
        first = wanted;
    }
    if (*first == wanted) return;
    throw Error("renderer: reproducible = " + std::to_string(wanted.reproducible) +
                ", threads = " + std::to_string(wanted.threads) +
                " differ from this process's first renderer (" +
                std::to_string(first->reproducible) + ", " + std::to_string(first->threads) +
                "); Mesa reads them once, use another process");
}

}  // namespace render
