#include "demos/commands/shared_options.h"

#include "demos/look/overlays.h"

namespace demos {

CLI::Option* takesAgain(CLI::Option* option) {
    return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option* takesList(CLI::Option* option) {
    return option->delimiter(',')->allow_extra_args(false);
}

void addRenderer(CLI::App& app, Options& options) {
    app.add_flag("--reproducible", options.reproducible,
                 "the same pixels on every x86-64 processor, a fifth slower; default: off");
    app.add_option("--context", options.context,
                   "what gives OpenGL: osmesa, egl or auto, the first that works; default: auto")
        ->type_name("NAME");
}

void addJobs(CLI::App& app, Options& options) {
    app.add_option("-j,--jobs", options.jobs, "drawing processes; default: 0, one a core")
        ->type_name("N");
}

void addSceneChoice(CLI::App& app, Options& options, OptionTexts& texts) {
    app.add_option("scene", options.scenes, "a built-in scene (impulse list) or a scene file")
        ->type_name("SCENE")
        ->expected(1)
        ->required();
    takesAgain(
        app.add_option("--set", options.overrides,
                       "a scene value, e.g. world.hz=240 or solver.sweeps=10; may be given again")
            ->type_name("KEY=VALUE"));
    app.add_option("--solver", texts.solver,
                   "the same as --set solver.type=NAME; default: the scene's")
        ->type_name("NAME");
}

void addFeedback(CLI::App& app, Options& options) {
    app.add_flag("--quiet", options.quiet, "print errors and asked-for results only; default: off");
    app.add_flag("--json", options.json, "one JSON object a line on standard output; default: off");
}

void addPicture(CLI::App& app, Options& options, OptionTexts& texts) {
    app.add_option("-q,--quality", options.quality,
                   "draft 480x270 @15, low 854x480 @30, medium 1280x720 @30, high 1920x1080 @60, "
                   "4k 3840x2160 @60, film 1280x720 @30 of 12 moments a frame; default: medium")
        ->type_name("NAME");
    app.add_option("--size", texts.size, "pixels, 1..16384 a side; default: the quality's")
        ->type_name("WxH");
    app.add_option("--fps", options.fps,
                   "frames a second; the scene's steps a second must be a multiple; "
                   "default: the quality's")
        ->type_name("N");
    app.add_option("--samples", options.samples,
                   "samples of a pixel with an edge: 1, 2, 4, 8 or 16; default: the quality's")
        ->type_name("N");
    app.add_option("--blur", options.blur,
                   "moments a frame is the mean of, 1..256: motion blur, soft shadows, "
                   "anti-aliasing; default: the quality's, 1 or 16")
        ->type_name("N");
    app.add_option("--shutter", options.shutter,
                   "with --blur: how much of a frame's time the shutter is open, 0..1; "
                   "default: 0.5")
        ->type_name("S");
    takesList(app.add_option("--show", texts.show,
                             "overlays, with commas: " + overlayList() + "; default: the scene's")
                  ->type_name("NAMES"));
    app.add_option("--theme", options.theme,
                   "studio, dark, print or transparent; default: the scene's")
        ->type_name("NAME");
    app.add_option("--colour-by,--color-by", options.colorBy,
                   "what colours bodies: body, speed, impulse, island, group, material or id; "
                   "default: the scene's")
        ->type_name("NAME");
    app.add_flag("--clean", options.clean, "no text in the picture; default: off");
    addRenderer(app, options);
    app.add_flag("--overwrite", options.overwrite,
                 "replace what another run has written; default: off");
}

void addFigure(CLI::App& app, Options& options, OptionTexts& texts) {
    app.add_option("--width", texts.width,
                   "width on paper, e.g. 85mm, 17cm, 3.35in, 241pt; a plain number is mm: type and "
                   "lines in points, theme print unless another is chosen, a caption beside the "
                   "file; --size then gives the ratio; default: none, for a screen")
        ->type_name("LENGTH");
    app.add_option("--dpi", texts.dpi, "with --width: pixels an inch, 72..2400; default: 300")
        ->type_name("N");
    app.add_option("--caption", options.caption,
                   "a text file for the caption and the settings; default: with --width beside the "
                   "figure, fig.png: fig.caption.txt")
        ->type_name("FILE");
}

void addSeconds(CLI::App& app, Options& options) {
    app.add_option("--seconds", options.seconds, "length in s; default: the scene's")
        ->type_name("S");
}

}  // namespace demos
