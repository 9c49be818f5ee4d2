/// The contents of the --pass files, frame by frame.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/film/composite.h"
#include "demos/film/contact_log.h"
#include "demos/film/event_log.h"
#include "demos/film/film_plan.h"
#include "render/data_images.h"

namespace demos {

using Bytes = std::vector<std::uint8_t>;

class DataFiles {
public:
    /// Watches the composite's steps from now on; `plan` and `composite` must outlive this object.
    DataFiles(const FilmPlan& plan, Composite& composite);

    /// One file's content for each of the plan's passes, at the composite's current frame. For the
    /// flow the composite advances to the next frame.
    std::vector<Bytes> make(int frame, render::Renderer& renderer);
    /// Advances by one frame, unless make() has done so. `drawn`: as Composite::advance.
    void advance(bool drawn);

private:
    void watch();
    void advanceOnce(bool drawn);
    bool goOn(int frame, render::Frame& next);
    Bytes textOf(Pass pass, int frame, const render::Camera& camera) const;
    Bytes imageOf(Pass pass, const render::DataImages& images) const;

    const FilmPlan& plan_;
    Composite& composite_;
    ContactLog log_;
    EventLog eventLog_;
    render::DataPasses images_;
    double depthUnit_;  // m
    bool ahead_ = false;
};

}  // namespace demos
