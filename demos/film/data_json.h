/// The text data passes, and passes.json, which describes all passes.
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

/// passes.json: files, units and meanings of every pass, and the numbers of bodies and joints.
/// `pattern`: the pictures' name pattern.
std::string passesJson(const FilmPlan& plan, const std::string& pattern);

/// m: the smallest of 0.1, 0.2, 0.5, 1 mm ... such that 65534 units are at least twice the distance
/// from any camera key to the farthest body at time 0.
double depthUnitOf(const SceneDescription& scene);

}  // namespace demos
