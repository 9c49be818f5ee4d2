#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/film_options.h"
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
    std::vector<std::string> words;  // of impulse render
};

/// After a part's command: it is complete too if it ended with 6, which the join reports again.
constexpr const char* kOrIncident = "|| [ $? -eq 6 ]";

/// The parts of a job file; the commands are quoted for a shell.
struct Job {
    std::string name;    // of the scene
    std::string render;  // impulse render ..., without --shard
    std::string join;    // impulse join ...
    int shards = 1;
};

std::string slurmText(const Job& job) {
    return fmt::format(
        "#!/bin/sh\n"
        "# Draws {3} parts, then joins them into one film. Run this file with sh. Finished parts\n"
        "# are not drawn again: run it again for what is missing. The join runs after all parts,\n"
        "# however they ended, and reports what is missing (exit code 7). A part that ended with 6\n"
        "# is complete.\n"
        "set -eu\n"
        "draw=$(sbatch --parsable --requeue --array=1-{3} --job-name={0} <<'END'\n"
        "#!/bin/sh\n"
        "exec {1} --shard \"$SLURM_ARRAY_TASK_ID/{3}\"\n"
        "END\n"
        ")\n"
        "sbatch --dependency=afterany:\"${{draw%%;*}}\" --job-name={0}-join <<'END'\n"
        "#!/bin/sh\n"
        "exec {2}\n"
        "END\n",
        shellWord(job.name), job.render, job.join, job.shards);
}

std::string parallelText(const Job& job) {
    return fmt::format(
        "#!/bin/sh\n"
        "# Run this file with sh. To use other machines, add --sshlogin or --sshloginfile to\n"
        "# parallel; this folder must be on all of them.\n"
        "seq {2} | parallel --retries 3 --joblog {0}.joblog {1}\n"
        "{3}\n",
        shellWord(job.name),
        shellWord(fmt::format("{} --shard {{}}/{} {}", job.render, job.shards, kOrIncident)),
        job.shards, job.join);
}

/// A command, escaped for a makefile's recipe.
std::string recipe(std::string command) {
    for (std::size_t at = 0; (at = command.find('$', at)) != std::string::npos; at += 2)
        command.insert(at, "$");
    return command;
}

std::string makeText(const Job& job) {
    return fmt::format(
        "# make -k -j 4 -f THIS_FILE\n"
        "parts := $(addprefix part-,$(shell seq {2}))\n"
        ".PHONY: film $(parts)\n"
        "film: $(parts)\n"
        "\t{1}\n"
        "$(parts):\n"
        "\t{0} --shard $(@:part-%=%)/{2} {3}\n",
        recipe(job.render), recipe(job.join), job.shards, recipe(kOrIncident));
}

std::string commandsText(const Job& job) {
    std::string text;
    for (int number = 1; number <= job.shards; ++number)
        text += fmt::format("{} --shard {}/{} {}\n", job.render, number, job.shards, kOrIncident);
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
    return fmt::format(
        "specificationVersion: jobtemplate-2023-09\n"
        "name: {0}\n"
        "steps:\n"
        "- name: draw\n"
        "  parameterSpace:\n"
        "    taskParameterDefinitions:\n"
        "    - {{name: Part, type: INT, range: \"1-{3}\"}}\n"
        "  script:\n"
        "    actions:\n"
        "      onRun: {{command: sh, args: [\"-c\", {1}]}}\n"
        "- name: join\n"
        "  dependencies: [{{dependsOn: draw}}]\n"
        "  script:\n"
        "    actions:\n"
        "      onRun: {{command: sh, args: [\"-c\", {2}]}}\n",
        quoted(job.name),
        quoted(fmt::format("{} --shard {{{{Task.Param.Part}}}}/{} {}", job.render, job.shards,
                           kOrIncident)),
        quoted(job.join), job.shards);
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

/// Refuses here what impulse render would refuse, by its own checks.
void checkRender(std::vector<std::string> words, int shards) {
    CLI::App app{"", "impulse render"};
    const Run run = renderCommand().add(app);
    words.insert(words.end(), {"--dry-run", "--quiet", "--shard", fmt::format("1/{}", shards)});
    std::reverse(words.begin(), words.end());
    try {
        app.parse(words);
    } catch (const CLI::ParseError& error) {
        refuse(fmt::format("impulse render refuses this: {}", printable(error.what())));
    }
    run("impulse render");
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

Job jobOf(const FarmOptions& options) {
    Job job;
    job.shards = options.shards;
    job.name = fs::path(options.words.front()).stem().string();
    job.render = "impulse render";
    for (const std::string& word : options.words) job.render += " " + shellWord(word);
    FilmOptions render;
    render.scenes = {options.words.front()};
    if (const std::string output = outputIn(options.words); !output.empty())
        render.outputs = {output};
    render.shard = Shard{1, options.shards};
    const Output output = outputsOf(planFilm(render), render).front();
    fs::path folder = output.part ? output.path.parent_path() : output.path;
    job.join = "impulse join " + shellWord(folder.string());
    if (output.part) job.join += " -o " + shellWord(render.outputs.front());
    return job;
}

Exit farm(const FarmOptions& options) {
    const Writer writer = writerOf(options.engine);
    checkRange("--shards", options.shards, 1, kMostShards);
    if (options.words.empty() || options.words.front().starts_with('-'))
        refuse(
            "farm: a scene must follow the engine, as in impulse farm slurm wall -o wall.mp4 "
            "--shards 16");
    checkRender(options.words, options.shards);
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
    app.footer("\nAll other arguments are passed to impulse render: the scene, -o, -q and so on.");
    // The parser no longer exists when the command runs.
    app.parse_complete_callback([options, &app] { options->words = app.remaining(); });
    return [options](const std::string&) { return farm(*options); };
}

}  // namespace

Command farmCommand() {
    return {"farm",
            "print a job file that draws a film in parts; nothing is started",
            {"impulse farm slurm wall -o wall.mp4 --shards 16",
             "impulse farm parallel wall -o wall.mp4 --shards 6 -q high",
             "impulse farm commands wall -o wall.mp4 --shards 4"},
            addFarm};
}

}  // namespace demos
