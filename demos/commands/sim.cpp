#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "demos/commands/commands.h"
#include "demos/commands/input_protection.h"
#include "demos/commands/play_through.h"
#include "demos/commands/shared_options.h"
#include "demos/commands/states.h"
#include "demos/export/pose_table.h"
#include "demos/film/event_log.h"
#include "demos/film/film_plan.h"
#include "demos/film/progress.h"
#include "demos/measures/direct_note.h"
#include "demos/measures/plot_file.h"
#include "demos/play/expect.h"
#include "demos/play/falls.h"
#include "demos/play/warnings.h"
#include "demos/snapshot/player.h"
#include "demos/text/complaints.h"
#include "demos/text/hex_text.h"
#include "demos/text/put_text.h"
#include "demos/text/shell_word.h"
#include "demos/text/table.h"

namespace demos {
namespace {

struct SimOptions : Options, StatesOptions {
    std::string csv, bodies, joints, contacts, sweeps,
        events;          // a file or "-"; empty = not written
    bool exact = false;  // sweeps are compared with the direct solution
    bool hash = false;
    int hashEvery = 0;  // 0 = the last step only
    bool expect = true;
    std::string plot;  // a file; empty = not drawn
};

namespace fs = std::filesystem;

/// The tables that one run writes, with one row or more per step.
struct Tables {
    Table energies, bodies, joints, contacts, sweeps;

    explicit Tables(const SimOptions& options)
        : energies(
              options.csv,
              "time,energy,kinetic,potential,contacts,penetration_max,separation_max,residual"),
          bodies(options.bodies, kPoseColumns),
          joints(options.joints, "time,joint,separation,force,torque,position,speed,broken"),
          contacts(options.contacts, "time,a,b,x,y,z,nx,ny,nz,penetration,impulse,friction"),
          sweeps(options.sweeps, options.exact ? "time,sweep,residual,delta,distance"
                                               : "time,sweep,residual,delta") {}

    std::vector<const Table*> wanted() const {
        std::vector<const Table*> tables;
        for (const Table* table : {&energies, &bodies, &joints, &contacts, &sweeps})
            if (table->wanted()) tables.push_back(table);
        return tables;
    }
};

void addEnergies(const Stage& stage, double time, Table& table) {
    const Measures m = measuresOf(stage);
    table.cell(time).cell(m.energy.total()).cell(m.energy.kinetic).cell(m.energy.potential);
    table.cell(m.contacts).cell(m.penetration).cell(m.separation).cell(m.residual);
    table.endRow();
}

void addBodies(const Stage& stage, double time, Table& table) {
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        addPoseRow(time, stage.scene.bodies[i].name, motionOf(stage, i), table);
}

/// The first coordinate that is free.
std::size_t coordinateOf(const engine::JointDef& def) {
    std::size_t i = 0;
    while (i + 1 < def.free.size() && def.free[i].locked) ++i;
    return i;
}

void addJoints(const Stage& stage, double time, Table& table) {
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const engine::JointState joint = stage.world.joint(stage.joints[i]);
        table.cell(time).cell(stage.scene.joints[i].name).cell(joint.separation);
        table.cell(joint.force.norm()).cell(joint.torque.norm());
        const std::size_t free = coordinateOf(joint.def);
        table.cell(joint.positions[free]).cell(joint.speeds[free]).cell(joint.broken ? 1 : 0);
        table.endRow();
    }
}

void addContacts(const Stage& stage, double time, Table& table) {
    for (const engine::ContactState& contact : stage.world.contacts()) {
        table.cell(time).cell(stage.nameOf(contact.a)).cell(stage.nameOf(contact.b));
        table.cells(contact.position).cells(contact.normal);
        table.cell(contact.penetration).cell(contact.impulse).cell(contact.friction.norm());
        table.endRow();
    }
}

void addSweeps(const Stage& stage, double time, Table& table) {
    int number = 0;
    for (const engine::SweepReport& sweep : stage.world.report().sweeps) {
        table.cell(time).cell(++number).cell(sweep.residual).cell(sweep.delta);
        if (stage.world.settings().compareExact)
            sweep.distance < 0.0 ? table.cell("") : table.cell(sweep.distance);
        table.endRow();
    }
}

/// Contacts and sweeps belong to a step that was taken, so time 0 has none.
void addRows(const Stage& stage, long step, Tables& tables) {
    const double time = static_cast<double>(step) / stage.scene.hz;
    if (tables.energies.wanted()) addEnergies(stage, time, tables.energies);
    if (tables.bodies.wanted()) addBodies(stage, time, tables.bodies);
    if (tables.joints.wanted()) addJoints(stage, time, tables.joints);
    if (step == 0) return;
    if (tables.contacts.wanted()) addContacts(stage, time, tables.contacts);
    if (tables.sweeps.wanted()) addSweeps(stage, time, tables.sweeps);
}

void writeAll(const Tables& tables, const Talk& talk) {
    for (const Table* table : tables.wanted()) {
        table->write();
        if (table->target() != "-")
            talk.say(fmt::format("wrote {} ({} rows)", printable(table->target()), table->rows()));
    }
}

/// True when standard output carries a table or the events.
bool checkTargets(const Tables& tables, const SimOptions& options) {
    std::vector<fs::path> seen;
    const auto add = [&](const std::string& target, const char* what) {
        const fs::path path = placeOf(target);
        if (std::find(seen.begin(), seen.end(), path) != seen.end())
            throw Stop(Exit::usage, fmt::format("{} for '{}'; give each its own file", what,
                                                printable(target)));
        seen.push_back(path);
    };
    for (const Table* table : tables.wanted()) add(table->target(), "two tables");
    if (!options.events.empty()) add(options.events, "a table and the events");
    const bool standard = std::find(seen.begin(), seen.end(), "-") != seen.end();
    if (!options.plot.empty()) add(options.plot, "a table and the plot");
    if (standard && options.json)
        throw Stop(Exit::usage, "--json uses standard output; write the table to a file");
    return standard;
}

/// Printed even with --quiet, because it was requested.
void sayHash(const Stage& stage, long step, const SimOptions& options, bool dataOnStdout) {
    const std::string hash = hexText(stage.world.hash());
    if (options.json)
        putText(stdout, fmt::format("{{\"event\":\"hash\",\"step\":{},\"state\":\"{}\"}}\n", step,
                                    hash));
    else
        putText(dataOnStdout ? stderr : stdout, fmt::format("step {}  state {}\n", step, hash));
}

/// False when one failed. Failures are errors, printed even with --quiet.
bool sayExpectations(const ExpectationChecker& checker, const SceneDescription& scene,
                     const Talk& talk) {
    bool allPassed = true;
    for (const ExpectationResult& result : checker.results()) {
        const std::string line = fmt::format("{}: {}", result.text, cameOut(result));
        allPassed = allPassed && result.passed;
        talk.json(fmt::format(
            R"({{"event":"expect","text":{},"value":{},"unit":{},"passed":{},"worst":{},"why":{}}})",
            jsonString(result.text),
            std::isfinite(result.value) ? numberText(result.value) : "null",
            jsonString(result.unit), result.passed, jsonString(result.worst),
            jsonString(result.why)));
        if (result.passed)
            talk.say("ok      " + line);
        else
            talk.complain(
                fmt::format("impulse: {}: failed: {}{}", scene.name, line,
                            result.why.empty() ? "" : " (" + printable(result.why) + ")"));
    }
    return allPassed;
}

/// A run in a few numbers, for a scene that expects nothing.
class RunInBrief {
public:
    /// To be called at the beginning and after every step.
    void look(const Stage& stage) {
        if (!startEnergy_) startEnergy_ = stage.world.energy().total();
        penetration_ = std::max(penetration_, stage.world.errors().penetration);
    }

    void say(const Stage& stage, const Talk& talk) const {
        talk.say(fmt::format("bodies       {}", stage.bodies.size()));
        talk.say(fmt::format("energy       {:.6g} J at the start, {:.6g} J at the end",
                             startEnergy_.value_or(0.0), stage.world.energy().total()));
        talk.say(fmt::format("penetration  {:.3g} m at most", penetration_));
        talk.say(fmt::format("state        {}", hexText(stage.world.hash())));
    }

private:
    std::optional<double> startEnergy_;  // J
    double penetration_ = 0.0;           // m
};

/// One run from time 0 to the end of the film.
class Simulation {
public:
    Simulation(const SimOptions& options, const SceneDescription& scene)
        : options_(options),
          tables_(options),
          dataOnStdout_(checkTargets(tables_, options)),
          talk_(options, dataOnStdout_),
          states_(options, options, scene),
          player_(scene, states_.overlays()),
          checker_(player_.stage()),
          choice_(plotChoiceOf(options, {}, scene)),
          steps_(stepsOf(scene)) {
        if (!options.plot.empty()) checkPlotFile(options.plot, choice_);
        states_.goOn(steps_, player_);
        if (!options.events.empty()) player_.watchTouches();
    }

    Exit play() {
        if (options_.from.empty())
            for (const std::string& line : warningsAtStart(player_.stage()))
                talk_.mention("warning: " + printable(line));
        playThrough(
            player_, options_, [this](long step) { look(step); }, [this] { writeResults(); });
        return finish();
    }

private:
    void look(long step) {
        const Stage& stage = player_.stage();
        if (expects()) checker_.look(stage);
        direct_.look(stage);
        falls_.look(stage);
        if (isBrief()) brief_.look(stage);
        if (step > 0) events_.look(stage);
        if (step % options_.every.value_or(1) == 0) addRows(stage, step, tables_);
        states_.look(player_, step);
        if (!options_.plot.empty()) recorder_.look(stage);
        const bool last = step == steps_;
        const bool every = options_.hashEvery > 0 && step % options_.hashEvery == 0;
        if ((last && (options_.hash || options_.hashEvery > 0)) || (every && step > 0))
            sayHash(stage, step, options_, dataOnStdout_);
    }

    bool isBrief() const { return player_.stage().scene.expectations.empty(); }
    /// Expectations are about the whole run.
    bool expects() const { return options_.expect && options_.from.empty(); }

    void writeResults() const {
        writeAll(tables_, talk_);
        if (!options_.events.empty()) writeEvents();
        if (options_.plot.empty()) return;
        const std::size_t charts = writePlot(options_.plot, recorder_, choice_);
        talk_.say(fmt::format("wrote {} ({} charts)", printable(options_.plot), charts));
    }

    void writeEvents() const {
        const std::string text = eventsJson(events_.events(), player_.stage()) + "\n";
        writeResult(options_.events,
                    {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        if (options_.events != "-")
            talk_.say(fmt::format("wrote {} ({} events)", printable(options_.events),
                                  events_.events().size()));
    }

    Exit finish() {
        const Stage& stage = player_.stage();
        const bool passed = !expects() || sayExpectations(checker_, stage.scene, talk_);
        writeResults();
        states_.finish(player_);
        states_.say(talk_);
        talk_.json(fmt::format(R"({{"event":"done","steps":{},"state":"{}"}})", steps_,
                               hexText(stage.world.hash())));
        for (const std::string& line : direct_.lines()) talk_.say(printable(line));
        if (const std::string line = falls_.line(stage); !line.empty())
            talk_.mention("warning: " + printable(line));
        for (const PlayedIncident& incident : player_.incidents()) {
            talk_.json(
                fmt::format(R"({{"event":"incident","text":{}}})", jsonString(incident.line)));
            talk_.complain("impulse: " + printable(incident.line));
        }
        if (!options_.from.empty() && options_.expect && !isBrief())
            talk_.say("expectations are not checked: they need the run from its beginning");
        talk_.say(fmt::format("{}: {} steps, {:.6g} s", stage.scene.name, steps_,
                              static_cast<double>(steps_) / stage.scene.hz));
        if (isBrief()) brief_.say(stage, talk_);
        talk_.say(fmt::format("next: impulse render {}", printable(shellWord(options_.scene()))));
        if (!player_.incidents().empty()) return Exit::diverged;
        return passed ? Exit::ok : Exit::failed;
    }

    const SimOptions& options_;
    Tables tables_;
    bool dataOnStdout_;
    Talk talk_;
    States states_;
    Player player_;
    ExpectationChecker checker_;
    DirectNote direct_;
    PlotChoice choice_;
    Recorder recorder_;
    RunInBrief brief_;
    Falls falls_;
    EventLog events_;
    long steps_;
};

Exit sim(const SimOptions& options) {
    SceneDescription scene = sceneOf(options);
    scene.settings.compareExact = options.exact;
    return Simulation(options, scene).play();
}

Run addSim(CLI::App& app) {
    const auto asked = std::make_shared<Asked<SimOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    addSeconds(app, options);
    const auto table = [&](const char* name, std::string& file, const char* columns) {
        app.add_option(name, file, std::string(columns) + "; default: not written")
            ->type_name("FILE|-");
    };
    table("--csv", options.csv,
          "one row per step: energies (J), contacts, penetration (m), residual");
    table("--bodies", options.bodies,
          "one row per step and body: position (m), rotation, velocities");
    table("--joints", options.joints,
          "one row per step and joint: separation (m), force, position");
    table("--contacts", options.contacts,
          "one row per contact point: position, normal, impulse (N s)");
    table("--sweeps", options.sweeps, "one row per sweep: residual (m/s), change (N s)");
    table("--events", options.events, "JSON: contacts that begin and end, joints that break");
    app.add_flag("--exact", options.exact,
                 "with --sweeps: adds the distance to the direct solution; slow; default: off");
    addStates(app, options, options, texts);
    app.add_option("--plot", options.plot,
                   "charts of energy, penetration, joints and residual over time, as .svg or .png; "
                   "default: not drawn")
        ->type_name("FILE");
    app.add_flag("--hash", options.hash, "print the last step's state hash; default: off");
    app.add_option("--hash-every", options.hashEvery,
                   "print every Nth step's state hash as well; default: 0, off")
        ->type_name("N");
    app.add_flag("--expect,!--no-expect", options.expect,
                 "check the scene's [[expect]]; default: on");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        const SimOptions& given = settled(*asked, commandLine);
        if (given.every) checkRange("--every", *given.every, 1, 1'000'000'000);
        checkRange("--hash-every", given.hashEvery, 0, 1'000'000'000);
        if (given.exact && given.sweeps.empty())
            refuse("--exact needs --sweeps; name a file for the sweeps");
        if (given.exact && !(given.states.empty() && given.from.empty()))
            refuse("--exact and states do not go together: it changes the bits");
        spareScenes(given.scenes, {given.csv, given.bodies, given.joints, given.contacts,
                                   given.sweeps, given.events, given.plot});
        spareOthers(ResultKind::table,
                    {given.csv, given.bodies, given.joints, given.contacts, given.sweeps});
        spareOthers(ResultKind::events, {given.events});
        spareOthers(ResultKind::chart, {given.plot});
        return sim(given);
    };
}

}  // namespace

Command simCommand() {
    return {
        "sim",
        "physics only: tables, state hash, the scene's expectations",
        {"impulse sim stack", "impulse sim stack --csv energy.csv --bodies bodies.csv --every 4",
         "impulse sim my.toml --set solver.sweeps=4 --hash"},
        addSim};
}

}  // namespace demos
