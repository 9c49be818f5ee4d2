// Runs scenes in one engine and prints a line for each: first the quality, then the cost of a step.
// Linked with one of peer_impulse.cpp, peer_bullet.cpp and peer_ode.cpp.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "tests/benchmark/peer_report.h"

namespace peers {

namespace {

struct Options {
    std::vector<std::string> scenes;
    std::string preset = presetNames().front();
    int threads = 1;
    int repeat = 3;  // runs for the cost
    bool quality = true;
    bool table = false;
    double seconds = 0.0;  // s of simulated time; 0: the scene's own
    double budget = std::numeric_limits<double>::infinity();  // s on the clock, of each run
};

const char* const kUsage =
    "usage: %s SCENE... [options]     one line of JSON per scene\n"
    "  --preset NAME   %s\n"
    "  --threads N     if the engine supports them (1)\n"
    "  --repeat N      runs to measure the cost, each from the start (3); 0: quality only\n"
    "  --noquality     cost only\n"
    "  --seconds T     simulated time instead of the scene's own\n"
    "  --budget T      seconds on the clock after which a run ends early\n"
    "  --table         a line of text instead of JSON\n"
    "scenes: %s\n";

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
    return all;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

double number(const std::string& option, const std::string& value) {
    std::size_t read = 0;
    double result = -1.0;
    try {
        result = std::stod(value, &read);
    } catch (const std::logic_error&) {  // reported below
    }
    if (read == 0 || read != value.size() || !(result >= 0.0))
        throw std::runtime_error(option + ": '" + value + "' should be a number, 0 or more");
    return result;
}

void set(Options& options, const std::string& name, const std::string& value) {
    if (name == "--preset")
        options.preset = value;
    else if (name == "--threads")
        options.threads = static_cast<int>(number(name, value));
    else if (name == "--repeat")
        options.repeat = static_cast<int>(number(name, value));
    else if (name == "--seconds")
        options.seconds = number(name, value);
    else if (name == "--budget")
        options.budget = number(name, value);
    else
        throw std::runtime_error("unknown option " + name);
}

Options optionsIn(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--noquality")
            options.quality = false;
        else if (words[i] == "--table")
            options.table = true;
        else if (words[i].rfind("--", 0) != 0)
            options.scenes.push_back(words[i]);
        else if (i + 1 == words.size())
            throw std::runtime_error(words[i] + " needs a value");
        else
            set(options, words[i], words[i + 1]), ++i;
    }
    if (options.scenes.empty()) throw std::runtime_error("no scene is named");
    if (!contains(presetNames(), options.preset))
        throw std::runtime_error("no preset '" + options.preset + "'; there are " +
                                 joined(presetNames(), ", "));
    if (!makeEngine(options.preset, options.threads))
        throw std::runtime_error(engineName() + " cannot step on " +
                                 std::to_string(options.threads) + " threads");
    return options;
}

Result run(const Scene& scene, const Options& options) {
    Result result{scene, options.preset, options.threads, {}, {}};
    const auto engine = [&] { return makeEngine(options.preset, options.threads); };
    if (options.quality) result.quality = watch(scene, *engine(), options.budget);
    std::vector<Cost> costs;
    for (int i = 0; i < options.repeat; ++i)
        costs.push_back(measureCost(scene, *engine(), options.budget));
    if (!costs.empty()) result.cost = median(costs);
    return result;
}

void runAll(const Options& options) {
    for (const std::string& name : options.scenes) {
        std::optional<Scene> scene = makeScene(name);
        if (!scene)
            throw std::runtime_error("no scene '" + name + "'; there are " +
                                     joined(sceneNames(), ", "));
        if (options.seconds > 0.0) scene->seconds = options.seconds;
        if (!makeEngine(options.preset, options.threads)->supports(*scene)) {
            std::fprintf(stderr, "%s: left out, %s's driver has no such shapes or joints\n",
                         name.c_str(), engineName().c_str());
            continue;
        }
        const Result result = run(*scene, options);
        std::printf("%s\n", (options.table ? tableLine(result) : json(result)).c_str());
        std::fflush(stdout);
    }
}

}  // namespace

}  // namespace peers

int main(int argc, char** argv) {
    using namespace peers;
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty() || contains(words, "--help")) {
        std::printf(kUsage, argv[0], joined(presetNames(), " | ").c_str(),
                    joined(sceneNames(), " ").c_str());
        return words.empty() ? 2 : 0;
    }
    try {
        runAll(optionsIn(words));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 2;
    }
}
