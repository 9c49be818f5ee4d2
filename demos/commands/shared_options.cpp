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
                   "source of OpenGL: osmesa, egl or auto, the first that works; default: auto")
        ->type_name("NAME");
}

void addWholeFrames(CLI::App& app, Options& options) {
    app.add_flag("--whole-frames", options.wholeFrames,
                 "draw every frame as a whole, not only what differs from the one before: the same "
                 "pixels, slower; default: off");
}

void addJobs(CLI::App& app, Options& options) {
    app.add_option("-j,--jobs", options.jobs, "drawing processes; default: 0, one per core")
        ->type_name("N");
}

void addSceneChoice(CLI::App& app, Options& options, OptionTexts& texts) {
    app.add_option("scene", options.scenes, "a built-in scene (impulse list) or a scene file")
        ->type_name("SCENE")
        ->expected(1)
        ->required();
    takesAgain(
        app.add_option("--set", options.overrides,
                       "change a scene value, e.g. world.hz=240 or 'body.box[3].mass=5'; may be "
                       "given again; 'impulse list --explain scene' lists the keys")
            ->type_name("KEY=VALUE"));
    app.add_option("--solver", texts.solver,
                   "the same as --set solver.type=NAME; default: the scene's")
        ->type_name("NAME");
}

void addFeedback(CLI::App& app, Options& options) {
    app.add_flag("--quiet", options.quiet, "print only errors and requested results; default: off");
    app.add_flag("--json", options.json,
                 "one JSON object per line on standard output; default: off");
}

void addMemory(CLI::App& app, Options& options, OptionTexts& texts) {
    takesList(app.add_option("--show", texts.show,
                             "overlays, with commas: " + overlayList() + "; default: the scene's")
                  ->type_name("NAMES"));
    app.add_option("--colour-by,--color-by", options.colorBy,
                   "what the bodies' colours show: body, speed, impulse, island, group, material "
                   "or id; default: the scene's")
        ->type_name("NAME");
}

void addPicture(CLI::App& app, Options& options, OptionTexts& texts) {
    app.add_option("-q,--quality", options.quality,
                   "draft 480x270 @15, low 854x480 @30, medium 1280x720 @30, high 1920x1080 @60, "
                   "4k 3840x2160 @60, film 1280x720 @30, 12 moments per frame; default: medium")
        ->type_name("NAME");
    app.add_option("--size", texts.size, "pixels, 1..16384 a side; default: the quality's")
        ->type_name("WxH");
    app.add_option("--fps", options.fps,
                   "frames per second; must divide the scene's steps per second; "
                   "default: the quality's")
        ->type_name("N");
    app.add_option("--samples", options.samples,
                   "samples per pixel at edges: 1, 2, 4, 8 or 16; default: the quality's")
        ->type_name("N");
    app.add_option("--blur", options.blur,
                   "moments averaged per frame, 1..256: motion blur, soft shadows, "
                   "anti-aliasing; default: the quality's, 1 or 12")
        ->type_name("N");
    app.add_option("--shutter", options.shutter,
                   "with --blur: the share of a frame's time that the shutter is open, 0..1; "
                   "default: 0.5")
        ->type_name("S");
    addMemory(app, options, texts);
    app.add_option("--theme", options.theme,
                   "studio, dark, print, transparent or lab; default: the scene's")
        ->type_name("NAME");
    app.add_flag("--clean", options.clean, "draw no text into the picture; default: off");
    addRenderer(app, options);
    app.add_flag("--overwrite", options.overwrite,
                 "replace files of another run; default: off");
}

void addFigure(CLI::App& app, Options& options, OptionTexts& texts) {
    app.add_option("--width", texts.width,
                   "width on paper, e.g. 85mm, 17cm, 3.35in, 241pt; a plain number is mm. Type and "
                   "lines are then in points, the theme is print unless another is chosen, a "
                   "caption is written next to the file, and --size gives the ratio; default: none, "
                   "for a screen")
        ->type_name("LENGTH");
    app.add_option("--dpi", texts.dpi, "with --width: pixels per inch, 72..2400; default: 300")
        ->type_name("N");
    app.add_option("--caption", options.caption,
                   "a text file for the caption and the settings; default: with --width next to "
                   "the figure (fig.caption.txt for fig.png)")
        ->type_name("FILE");
}

void addSeconds(CLI::App& app, Options& options) {
    app.add_option("--seconds", options.seconds, "length in s; default: the scene's")
        ->type_name("S");
}

}  // namespace demos
