#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "demos/commands/commands.h"
#include "demos/commands/render_options.h"
#include "demos/film/film_plan.h"
#include "demos/film/outputs.h"
#include "demos/text/complaints.h"
#include "demos/text/put_text.h"
#include "demos/text/shell_word.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

struct FarmOptions {
    std::string engine;
    int shards = 0;
    std::string command = "render";  // of the parts
    std::vector<std::string> words;  // of that command
};

/// The parts of a job file; the commands are quoted for a shell.
struct Job {
    std::string name;   // of the scene
    std::string states; // impulse sim ... --states, before the parts; may be empty
    std::string part;   // impulse render ..., without --shard
    std::string good;   // after a part's command: the exit code of a complete part, besides 0
    std::string join;   // impulse join ...
    int shards = 1;
};

std::string slurmText(const Job& job) {
    std::string states, after;
    if (!job.states.empty()) {
        states = fmt::format(
            "states=$(sbatch --parsable --requeue --job-name={0}-states \"$@\" <<'END'\n"
            "#!/bin/sh\n"
            "{1}\n"
            "END\n"
            ")\n",
            shellWord(job.name), job.states);
        after = " --dependency=afterany:\"${states%%;*}\"";
    }
    return fmt::format(
        "#!/bin/sh\n"
        "# Runs {3} parts, then joins them. Run this file with sh. Complete parts are not run\n"
        "# again: run it again for what is missing. The join runs after all parts, however they\n"
        "# ended, and reports what is missing (exit code 7). Options of sbatch (a partition, an\n"
        "# account, a time limit) go after sh THIS_FILE.\n"
        "set -eu\n"
        "{5}"
        "parts=$(sbatch --parsable --requeue --array=1-{3}{6} --job-name={0} \"$@\" <<'END'\n"
        "#!/bin/sh\n"
        "{1} --shard \"$SLURM_ARRAY_TASK_ID/{3}\"{4}\n"
        "END\n"
        ")\n"
        "sbatch --dependency=afterany:\"${{parts%%;*}}\" --job-name={0}-join \"$@\" <<'END'\n"
        "#!/bin/sh\n"
        "exec {2}\n"
        "END\n",
        shellWord(job.name), job.part, job.join, job.shards, job.good, states, after);
}

/// As a line of a shell script.
std::string lineOf(const std::string& command) { return command.empty() ? "" : command + "\n"; }

std::string parallelText(const Job& job) {
    return fmt::format(
        "#!/bin/sh\n"
        "# Run this file with sh. To use other machines, add --sshlogin or --sshloginfile to\n"
        "# parallel; this folder must be on all of them.\n"
        "{4}seq {2} | parallel --retries 3 --joblog {0}.joblog {1}\n"
        "{3}\n",
        shellWord(job.name),
        shellWord(fmt::format("{} --shard {{}}/{}{}", job.part, job.shards, job.good)),
        job.shards, job.join, lineOf(job.states));
}

/// A command, escaped for a makefile's recipe.
std::string recipe(std::string command) {
    for (std::size_t at = 0; (at = command.find('$', at)) != std::string::npos; at += 2)
        command.insert(at, "$");
    return command;
}

std::string makeText(const Job& job) {
    const std::string states =
        job.states.empty() ? "" : "$(parts): states\n.PHONY: states\nstates:\n\t" + recipe(job.states) + "\n";
    return fmt::format(
        "# make -k -j 4 -f THIS_FILE\n"
        "parts := $(addprefix part-,$(shell seq {2}))\n"
        ".PHONY: all $(parts)\n"
        "all: $(parts)\n"
        "\t{1}\n"
        "$(parts):\n"
        "\t{0} --shard $(@:part-%=%)/{2}{3}\n"
        "{4}",
        recipe(job.part), recipe(job.join), job.shards, recipe(job.good), states);
}

std::string commandsText(const Job& job) {
    std::string text = lineOf(job.states);
    for (int number = 1; number <= job.shards; ++number)
        text += fmt::format("{} --shard {}/{}{}\n", job.part, number, job.shards, job.good);
    return text + job.join + "\n";
}

/// In double quotes, escaped for YAML and JSON.
std::string quoted(const std::string& text) {
    std::string all = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') all += '\\';
        all += c;
    }
    return all + "\"";
}

std::string openJobText(const Job& job) {
    std::string states, after;
    if (!job.states.empty()) {
        states = fmt::format(
            "- name: states\n"
            "  script:\n"
            "    actions:\n"
            "      onRun: {{command: sh, args: [\"-c\", {}]}}\n",
            quoted(job.states));
        after = "  dependencies: [{dependsOn: states}]\n";
    }
    return fmt::format(
        "specificationVersion: jobtemplate-2023-09\n"
        "name: {0}\n"
        "steps:\n"
        "{4}"
        "- name: parts\n"
        "{5}"
        "  parameterSpace:\n"
        "    taskParameterDefinitions:\n"
        "    - {{name: Part, type: INT, range: \"1-{3}\"}}\n"
        "  script:\n"
        "    actions:\n"
        "      onRun: {{command: sh, args: [\"-c\", {1}]}}\n"
        "- name: join\n"
        "  dependencies: [{{dependsOn: parts}}]\n"
        "  script:\n"
        "    actions:\n"
        "      onRun: {{command: sh, args: [\"-c\", {2}]}}\n",
        quoted(job.name),
        quoted(fmt::format("{} --shard {{{{Task.Param.Part}}}}/{}{}", job.part, job.shards,
                           job.good)),
        quoted(job.join), job.shards, states, after);
}

using Writer = std::string (*)(const Job&);
constexpr std::pair<const char*, Writer> kEngines[] = {{"slurm", slurmText},
                                                       {"parallel", parallelText},
                                                       {"make", makeText},
                                                       {"commands", commandsText},
                                                       {"openjd", openJobText}};

Writer writerOf(const std::string& engine) {
    std::vector<std::string> names;
    for (const auto& [name, writer] : kEngines) {
        if (name == engine) return writer;
        names.emplace_back(name);
    }
    checkName("ENGINE", engine, names);
    return nullptr;
}

/// Refuses here what the command would refuse, by its own checks.
void checkPart(const Command& command, std::vector<std::string> words, int shards) {
    const std::string name = std::string("impulse ") + command.name;
    CLI::App app{"", name};
    const Run run = command.add(app);
    words.insert(words.end(), {"--dry-run", "--quiet", "--shard", fmt::format("1/{}", shards)});
    std::reverse(words.begin(), words.end());
    try {
        app.parse(words);
    } catch (const CLI::ParseError& error) {
        refuse(fmt::format("{} refuses this: {}", name, printable(error.what())));
    }
    run(name);
}

/// The value of -o among the words; empty: the default.
std::string outputIn(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        for (const std::string option : {"-o", "--output"})
            if (words[i] == option && i + 1 < words.size()) return words[i + 1];
        if (words[i].starts_with("--output=")) return words[i].substr(9);
        if (words[i].starts_with("-o")) return words[i].substr(2);
    }
    return {};
}

bool hasScene(const FarmOptions& options) {
    return !options.words.empty() && !options.words.front().starts_with('-');
}

/// impulse join ... for the parts of a film.
std::string joinOf(const FilmPlan& plan, const FilmOptions& render) {
    const Output output = outputsOf(plan, render).front();
    const fs::path folder = output.part ? output.path.parent_path() : output.path;
    const std::string join = "impulse join " + shellWord(folder.string());
    return output.part ? join + " -o " + shellWord(render.outputs.front()) : join;
}

/// impulse sim ... --states, for parts that start from states: with the options of the parts that change a
/// simulation or what its states remember. Four states a part. Empty: the parts do not ask for states.
std::string statesOf(const CLI::App& given, const FilmPlan& plan, const FilmOptions& render) {
    if (render.states.empty()) return {};
    const long steps = plan.stepOf(plan.frames);
    std::string command = "impulse sim " + shellWord(render.scenes.front());
    for (const char* name : {"--set", "--solver", "--seconds", "--colour-by", "--states"})
        for (const std::string& value : given.get_option(name)->results())
            command += fmt::format(" {} {}", name, shellWord(value));
    const std::string show = fmt::format("{}", fmt::join(given.get_option("--show")->results(), ","));
    if (!show.empty()) command += " --show " + shellWord(show);
    const long every = std::max(steps / (4L * render.shard->count), 1L);
    return command + fmt::format(" --every {} --no-expect --quiet", every);
}

/// What depends on the film: its words are read as impulse render reads them.
void planParts(const FarmOptions& options, Job& job) {
    CLI::App app;
    Asked<FilmOptions> asked;
    addRenderOptions(app, asked.options, asked.texts);
    app.parse(std::vector<std::string>(options.words.rbegin(), options.words.rend()));
    FilmOptions& render = settled(asked, "");
    render.shard = Shard{1, options.shards};
    const FilmPlan plan = planFilm(render);
    job.good = " || [ $? -eq 6 ]";  // an incident, which the join reports again
    job.join = joinOf(plan, render);
    job.states = statesOf(app, plan, render);
    if (!job.states.empty()) job.states += job.good;
}

Job jobOf(const FarmOptions& options) {
    Job job;
    job.shards = options.shards;
    job.name = hasScene(options) ? fs::path(options.words.front()).stem().string() : "";
    if (job.name.empty()) job.name = options.command;  // a folder, or all scenes
    job.part = "impulse " + options.command;
    for (const std::string& word : options.words) job.part += " " + shellWord(word);
    if (options.command == "render") {
        planParts(options, job);
    } else if (options.command == "test") {
        job.good = " || [ $? -eq 1 ]";  // scenes that failed
        const std::string output = outputIn(options.words);
        job.join = "impulse test --merge";
        if (!output.empty()) job.join += " -o " + shellWord(output);
    } else {
        job.join = job.part + " --merge";
    }
    return job;
}

/// Takes the command from the words: without one, they are those of impulse render.
Command takeCommand(FarmOptions& options) {
    for (const Command& command :
         {sweepCommand(), compareCommand(), testCommand(), renderCommand()})
        if (!options.words.empty() && options.words.front() == command.name) {
            options.command = command.name;
            options.words.erase(options.words.begin());
            return command;
        }
    return renderCommand();
}

Exit farm(FarmOptions options) {
    const Writer writer = writerOf(options.engine);
    checkRange("--shards", options.shards, 1, kMostShards);
    const Command command = takeCommand(options);
    if (options.command != "test" && !hasScene(options))
        refuse(
            "farm: a scene must follow the engine, as in impulse farm slurm wall -o wall.mp4 "
            "--shards 16");
    checkPart(command, options.words, options.shards);
    putText(stdout, writer(jobOf(options)));
    return Exit::ok;
}

Run addFarm(CLI::App& app) {
    const auto options = std::make_shared<FarmOptions>();
    app.add_option("engine", options->engine, "slurm, parallel, make, commands or openjd")
        ->type_name("ENGINE")
        ->required();
    app.add_option("--shards", options->shards, "number of parts")->type_name("N")->required();
    app.allow_extras();
    app.footer(
        "\nAll other arguments are passed to impulse render: the scene, -o, -q and so on; or to "
        "impulse\nsweep, compare or test, if they begin with this word.");
    // The parser no longer exists when the command runs.
    app.parse_complete_callback([options, &app] { options->words = app.remaining(); });
    return [options](const std::string&) { return farm(*options); };
}

}  // namespace

Command farmCommand() {
    return {"farm",
            "print a job file that runs a film, sweep or test in parts; nothing is started",
            {"impulse farm slurm wall -o wall.mp4 --shards 16",
             "impulse farm parallel wall -o wall.mp4 --shards 6 -q high",
             "impulse farm slurm sweep chain --over solver.substeps=1..32 --shards 8"},
            addFarm};
}

}  // namespace demos
