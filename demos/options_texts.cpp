// What every command is called, is for, and three examples of it.

#include "demos/options_commands.h"

namespace demos {
namespace {

constexpr CommandText kCommands[] = {
    {Command::render,
     "render",
     "simulate and write a film: PNG frames, or a video",
     {"impulse render stack", "impulse render stack -o stack.mp4 -q high",
      "impulse render my.toml -o 'frames/{scene}_####.png' --show contacts,impulses"}},
    {Command::still,
     "still",
     "draw one frame",
     {"impulse still stack -t 2.0", "impulse still stack -f -1 -o last.png -q 4k",
      "impulse still my.toml -t 0.5 --show impulses --theme print"}},
    {Command::strip,
     "strip",
     "a row of moments as one picture, for paper or a slide",
     {"impulse strip stack", "impulse strip wall -n 8 --columns 4 --theme print -o wall.png",
      "impulse strip chain --times 0,0.5,1,2 --size 480x360"}},
    {Command::sim,
     "sim",
     "physics only: tables, state hash, the scene's expectations",
     {"impulse sim stack", "impulse sim stack --csv energy.csv --bodies bodies.csv --every 4",
      "impulse sim my.toml --set solver.sweeps=4 --hash"}},
    {Command::plot,
     "plot",
     "physics only: charts of energy, penetration, impulses, residuals",
     {"impulse plot stack", "impulse plot stack -o stack.png --what energy,impulse --theme dark",
      "impulse plot my.toml -o a.svg -o a.png --size 1920x1080 --set solver.sweeps=4"}},
    {Command::compare,
     "compare",
     "one scene under two to four settings, side by side in one film, with a table",
     {"impulse compare clamping", "impulse compare stack --vary solver.nudges=0,4 -o nudges.mp4",
      "impulse compare chain --no-film --vary solver.type=impulses,pgs --set solver.preset=seed"}},
    {Command::sweep,
     "sweep",
     "one setting over many values: a table, a plot, a grid of films",
     {"impulse sweep chain --over solver.substeps=1..32:x2",
      "impulse sweep stack --over solver.sweeps=1..20 --csv sweeps.csv --plot sweeps.svg",
      "impulse sweep bridge --over world.hz=30,60,120,240 -o grid.mp4"}},
    {Command::test,
     "test",
     "pictures, states and expectations of scenes against their baselines",
     {"impulse test", "impulse test scenes/ --baselines snapshots -o results",
      "impulse test my.toml --self-test"}},
    {Command::approve,
     "approve",
     "take what a test drew as the new baseline",
     {"impulse approve stack@2.5 wall", "impulse approve --all", "impulse approve --prune"}},
    {Command::list,
     "list",
     "the built-in scenes",
     {"impulse list", "impulse list stack --print > my.toml",
      "impulse list --gallery -o scenes.png"}},
    {Command::doctor,
     "doctor",
     "what this machine can do",
     {"impulse doctor", "impulse doctor --json", "impulse doctor --quiet && impulse render stack"}},
    {Command::bench,
     "bench",
     "time per step over the last 2 s of a scene, or per frame of its film",
     {"impulse bench stack chain --json", "impulse bench wall --phases --against before.json",
      "impulse bench wall --film -q film"}},
    {Command::completion,
     "completion",
     "a completion script for a shell",
     {"impulse completion bash", "source <(impulse completion bash)",
      "impulse completion bash > ~/.local/share/bash-completion/completions/impulse"}},
};

}  // namespace

std::span<const CommandText> commandTexts() { return kCommands; }

}  // namespace demos
