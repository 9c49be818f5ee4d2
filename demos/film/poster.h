/// One frame of a film as a picture of its own, for pages that show it before the film plays.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/film/film_options.h"
#include "demos/film/film_plan.h"
#include "demos/film/frame_source.h"
#include "demos/film/progress.h"
#include "render/encode/file.h"

namespace demos {

/// Written when the film is complete; an interrupted run leaves no poster.
class Poster {
public:
    /// Throws Stop (usage, wouldOverwrite). Without --poster it wants no frame.
    Poster(const FilmPlan& plan, const FilmOptions& options);
    bool wants(int frame) const { return frame == frame_; }
    void add(const DrawnFrame& frame);
    /// Throws render::Error.
    void write() const;
    void tell(const FilmPlan& plan, const Talk& talk) const;

private:
    std::string target_;
    int frame_ = -1;
    std::vector<std::uint8_t> png_;
    render::Existing existing_ = render::Existing::replaced;
};

/// --poster-time, else what the first section with a poster says, else the middle.
int posterFrame(const FilmPlan& plan, const std::optional<double>& time = std::nullopt);

}  // namespace demos
