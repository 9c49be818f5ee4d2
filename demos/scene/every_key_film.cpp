// [camera], [look], [[section]], [snapshot] and [[expect]]

#include "demos/scene/description.h"
#include "demos/scene/every_key.h"

namespace demos {
namespace {

const std::vector<KeyExample> kFilmExamples{
    {"camera", R"(
[camera]
from = [8, 5, 14]
look_at = [0, 4, 0]
fov_deg = 35
orbit_deg_per_s = 0
follow = "ball"
follow_lag = 0.5
aperture = 0.1
focus = "ball"
keys = [{ at = 1, from = [4, 2, 9], look_at = [0, 2, 0], fov_deg = 30, ease = "out" }]
)"},
    {"move", "\n[camera]\nmove = \"push\"\n"},
    {"focus", "\n[camera]\nfocus = 3\nfollow = \"crate\"\n"},
    {"look", R"(
[look]
theme = "studio"
show = ["contacts"]
colour_by = "body"
colour_max = 1
ghost_every = 0.25
reflection = 0.2
dither = true
light = [-1, 1, 2]
plot = "energy"
trails = ["ball"]
[snapshot]
times = [0, 1]
size = [64, 36]
tolerance = { position = 0.001, angle_deg = 0.1, load = 0.2, why = "w" }
gate = { levels = 3, window = 8, ssim = 0.9, why = "w" }
)"},
    {"section", R"(
[[section]]
at = 0
name = "start"
caption = "c"
notes = "n"
poster = "last"
slow = 0.5
pause = false
loop = false
title = "t"
text = "t"
formula = ["a", "b"]
plot = ["energy"]
table = ["measures", "expectations"]
[[section]]
at = 1
poster = 1
formula = "a"
)"},
    {"expect", R"(
[[expect]]
what = "speed"
of = ["ball"]
above = -1
below = 100
after = 0
until = 1
why = "w"
[[expect]]
what = "speed"
near = 0
within = 100
[[expect]]
what = "position"
of = "ball"
near = [0, 0, 0]
within = 100
)"},
};

TableTexts cameraTexts() {
    return {"[camera]",
            {
                {"from", inToml(CameraDescription{}.from),
                 "The place of the camera; without it, look_at, keys and follow the picture shows "
                 "the motion of the whole run."},
                {"look_at", inToml(CameraDescription{}.lookAt),
                 "The point in the middle of the picture."},
                {"fov_deg", inToml(CameraDescription{}.fovDegrees),
                 "The vertical angle of view: small like a telephoto lens from afar, large like a "
                 "wide-angle lens."},
                {"orbit_deg_per_s", inToml(CameraDescription{}.orbitDegreesPerSecond),
                 "How fast the camera circles look_at about the vertical; 20 shows a still scene "
                 "from all sides in 18 s."},
                {"move", inToml(std::string("none")),
                 "A slow motion over the whole film: push moves in by 12 %, orbit circles by 25 "
                 "degrees, follow keeps the middle of all moving bodies in the picture."},
                {"follow", "none",
                 "A body with which the camera moves along, keeping its distance and direction."},
                {"follow_lag", inToml(CameraDescription{}.followLag),
                 "The time constant with which the camera lags behind what it follows, 0.5 by "
                 "default with move = \"follow\"; a few tenths make it calm."},
                {"aperture", inToml(CameraDescription{}.aperture),
                 "The radius of the lens, by which things out of focus are blurred; only pictures "
                 "of several moments show it (--blur 16, -q film)."},
                {"focus", "the distance of look_at",
                 "What is sharp with an aperture: a distance along the view, or the name of a body "
                 "that stays sharp as it moves."},
                {"keys", "none", "Later positions of the camera, between which it moves."},
            }};
}

TableTexts cameraKeyTexts() {
    return {"a key of the camera",
            {
                {"at", "required",
                 "The time at which the camera arrives at this key, later than the key before."},
                {"from", "as in the key before", "The place of the camera at this time."},
                {"look_at", "as in the key before",
                 "The point in the middle of the picture at this time."},
                {"fov_deg", "as in the key before",
                 "The vertical angle of view at this time; a change zooms."},
                {"ease", inToml(std::string("smooth")),
                 "How the camera moves to this key: smooth starts and ends at rest, in only starts "
                 "and out only ends at rest, cut jumps."},
            }};
}

TableTexts lookTexts() {
    return {"[look]",
            {
                {"theme", inToml(LookDescription{}.theme),
                 "Sky, ground and ink of the picture: studio and dark for screens, print for "
                 "paper, transparent to lay the film over something else, lab with a ruled floor to "
                 "measure by."},
                {"show", "[]",
                 "Overlays that explain the physics, such as contacts, impulses, joints and stats; "
                 "--show adds more."},
                {"colour_by", inToml(LookDescription{}.colorBy),
                 "What the colour of a body means: its own colour, its speed, its impulses, or "
                 "what it belongs to."},
                {"colour_max", "the largest value so far",
                 "The speed or impulse at the top of the colour scale; fix it when films are "
                 "compared or a crash makes all else dark."},
                {"ghost_every", inToml(LookDescription{}.ghostEvery),
                 "The time between the fading earlier poses that the overlay ghost draws; shorten "
                 "it for fast motion."},
                {"reflection", inToml(LookDescription{}.reflection),
                 "How clearly the floor mirrors the bodies, 0 to 1; 0.2 looks like varnish, and films take "
                 "longer."},
                {"dither", inToml(LookDescription{}.dither),
                 "Noise of one level of 255, the same in every frame, so that the sky has no faint bands; files "
                 "become up to two and a half times as large, and `impulse test` draws without it."},
                {"light", "beside the camera: 50 degrees to its left, 38 above the ground",
                 "The direction towards the key light, of any length, from at least 10 degrees above the "
                 "ground; shadows fall the other way."},
                {"plot", inToml(LookDescription{}.plot),
                 "The measure that the overlay plot draws over time below the film."},
                {"trails", "[]", "Bodies whose paths are drawn, by name or with *."},
            }};
}

TableTexts snapshotTexts() {
    return {
        "[snapshot]",
        {
            {"times", "[]",
             "The times, in rising order, whose picture and state `impulse test` compares; choose "
             "moments that would reveal a change."},
            {"size", "[" + inToml(Snapshot{}.width) + ", " + inToml(Snapshot{}.height) + "]",
             "Width and height of the saved pictures; small ones are quick to draw and to review."},
            {"tolerance", "the defaults of its keys",
             "How far bodies may deviate from the saved state; widen it only where the motion is "
             "chaotic."},
            {"gate", "the defaults of its keys",
             "How much a picture may differ from the saved one; widen it only where thin things "
             "flicker."},
        }};
}

TableTexts toleranceTexts() {
    return {"a tolerance",
            {
                {"position", inToml(Tolerance{}.position),
                 "The distance from its saved place above which a body counts as moved."},
                {"angle_deg", inToml(Tolerance{}.angleDegrees),
                 "The rotation away from its saved one above which a body counts as turned."},
                {"load", inToml(Tolerance{}.load),
                 "The share by which the load of a body, the impulses of its contacts and joints, "
                 "may differ."},
                {"why", "required",
                 "The reason for other tolerances than the defaults, which reports repeat."},
            }};
}

TableTexts gateTexts() {
    return {"a gate",
            {
                {"levels", inToml(PictureGate{}.levels),
                 "The difference of a colour above which a pixel counts as changed."},
                {"window", inToml(PictureGate{}.windowPixels),
                 "The changed pixels that any window of 16x16 may have."},
                {"ssim", inToml(PictureGate{}.ssim),
                 "The least structural similarity of every block of 8x8 pixels; 1 is identical."},
                {"why", "required",
                 "The reason for another gate than the default, which reports repeat."},
            }};
}

TableTexts sectionTexts() {
    return {
        "a [[section]]",
        {
            {"at", inToml(Section{}.at),
             "The time at which the chapter begins; it lasts until the next one."},
            {"name", inToml(Section{}.name),
             "The name by which decks refer to the chapter, and under which `impulse watch` "
             "reports its changes."},
            {"caption", inToml(Section{}.caption),
             "The line in the picture from this time on, which says what to look at; $x^2$ is a formula in LaTeX; "
             "an empty one keeps the line before."},
            {"notes", inToml(Section{}.notes),
             "Notes for the speaker, which only the slides have."},
            {"poster", "the middle of the film; on slides the last frame",
             "The frame that stands for the chapter on paper and in previews: the first, the last, "
             "or a time of the run."},
            {"slow", inToml(Section{}.slow),
             "Plays the chapter at this share of its speed, in films and on its slide; 0.25 shows a "
             "crash four times slower, above 1 is a time lapse."},
            {"pause", inToml(Section{}.pause),
             "Lets the film on the slide wait on its first frame until the speaker starts it."},
            {"loop", inToml(Section{}.loop), "Starts the film on the slide again at its end."},
            {"title", "the title of the scene", "The title of the slide."},
            {"text", inToml(SectionSlide{}.text),
             "The words of the slide, in CommonMark with formulas."},
            {"formula", "[]", "Formulas of the slide in LaTeX, each on its own line."},
            {"plot", "[]",
             "Charts next to the film, by the names that `impulse plot --what` takes."},
            {"table", "[]",
             "Tables on the slide: measures of the run, or the expectations with what came out."},
        }};
}

TableTexts expectTexts() {
    return {
        "an [[expect]]",
        {
            {"what", "required",
             "The measure: of bodies their drift, speed, height, angle_deg, position, spread, "
             "period or count, of joints their separation, of the world its penetration or "
             "energy."},
            {"of", inToml(Expectation{}.of),
             "The bodies or joints that are measured, by name or with *; each of them has to meet "
             "the bound, while count and spread are those of all."},
            {"below", "none", "The bound under which the measure has to stay."},
            {"above", "none", "The bound over which the measure has to be."},
            {"near", "required for position, else none",
             "The value, or the point of a position, that the measure has to be close to."},
            {"within", "required with near", "The largest distance of the measure from `near`."},
            {"after", inToml(Expectation{}.after),
             "The time from which it is measured; later than 0, it leaves out how things settle."},
            {"until", "the end of the film",
             "The time until which it is measured, and at which position and spread are taken."},
            {"why", inToml(Expectation{}.why),
             "The reason in one line, which reports repeat when the expectation fails."},
        }};
}

}  // namespace

KeyPart filmKeys() {
    return {kFilmExamples,
            {cameraTexts(), cameraKeyTexts(), lookTexts(), snapshotTexts(), toleranceTexts(),
             gateTexts(), sectionTexts(), expectTexts()}};
}

}  // namespace demos
