/// The data passes that are text, and the description of them all.
#pragma once
#include <string>
#include <vector>

#include "demos/film/contact_log.h"
#include "demos/film/event_log.h"
#include "demos/film/film_plan.h"

namespace demos {

std::string cameraJson(const FilmPlan& plan, int frame, const render::Camera& camera);
std::string posesJson(const FilmPlan& plan, int frame, const Stage& stage);
std::string contactsJson(const FilmPlan& plan, int frame, const Stage& stage,
                         const std::vector<ContactEvent>& events);
std::string eventsJson(const FilmPlan& plan, int frame, const Stage& stage,
                       const StageEvents& events);

/// passes.json: files, units and meanings of every pass, and the bodies by their numbers.
/// `pattern`: of the pictures' names.
std::string passesJson(const FilmPlan& plan, const std::string& pattern);

/// m: the smallest of 0.1, 0.2, 0.5, 1 mm ... of which 65534 reach twice as far as all that the
/// scene begins with, from wherever the camera's keys put it.
double depthUnitOf(const SceneDescription& scene);

}  // namespace demos
