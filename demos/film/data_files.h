/// The content of the files that --pass asks for, frame by frame.
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
    /// Watches the screen's steps from now on; `plan` and `screen` have to stay.
    DataFiles(const FilmPlan& plan, Composite& composite);

    /// A file's content for each of the plan's passes, of the frame the screen is at. For the flow
    /// the screen goes on to the next frame.
    std::vector<Bytes> make(int frame, render::Renderer& renderer);
    /// One frame further, unless the screen is there already. `drawn`: as Composite::advance.
    void advance(bool drawn);

private:
    void watch();
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
