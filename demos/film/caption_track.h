/// The captions of a film as a file of their own (WebVTT), for players that show them as subtitles
/// or chapters.
#pragma once
#include <string>

#include "demos/film/film_options.h"
#include "demos/film/film_plan.h"
#include "demos/film/progress.h"
#include "render/encode/file.h"

namespace demos {

/// A cue per section with a caption, until the next one; times are those of the whole film. Empty: no
/// section has a caption.
std::string captionTrackText(const FilmPlan& plan);

/// Written when the film is complete, like a poster.
class CaptionTrack {
public:
    /// Throws Stop (usage, wouldOverwrite). Without --captions nothing is written.
    CaptionTrack(const FilmPlan& plan, const FilmOptions& options);
    /// Throws render::Error.
    void write() const;
    void tell(const Talk& talk) const;

private:
    std::string target_, text_;
    render::Existing existing_ = render::Existing::replaced;
};

}  // namespace demos
