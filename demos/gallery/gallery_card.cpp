#include "demos/gallery/gallery_card.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "demos/film/poster.h"
#include "demos/film/progress.h"
#include "demos/film/scene_fps.h"
#include "demos/load/load_scene.h"
#include "demos/text/text_hash.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

constexpr PictureSize kFilm{640, 360};

}  // namespace

GalleryOptions optionsOfFilm(const GalleryChoice& choice, const GalleryOptions& options) {
    GalleryOptions own = options;
    own.scenes = {choice.scene};
    if (!own.size && !own.qualityAsked) own.size = kFilm;
    suitFilm(loadScene(choice.scene, options.overrides), own);
    return own;
}

GalleryCard cardOf(const GalleryChoice& choice, const FilmPlan& plan, const GalleryOptions& options,
                   const std::string& renderer) {
    const SceneDescription& scene = plan.scene();
    GalleryCard card;
    card.name = choice.name;
    card.group = scene.group;
    card.title = scene.title;
    card.purpose = scene.purpose;
    if (!choice.builtin) card.file = std::filesystem::path(choice.scene).filename().string();
    card.seconds = plan.seconds();
    card.posterTime = plan.timeOf(posterFrame(plan));
    card.bodies = static_cast<int>(scene.bodies.size());
    card.joints = static_cast<int>(scene.joints.size());
    card.hz = scene.hz;
    card.frames = plan.frames;
    card.fps = plan.fps;
    card.width = plan.layout.width;
    card.height = plan.layout.height;
    TextHash hash;
    hash.add(hexText(fingerprintOf(plan, options)));
    hash.add(renderer);
    card.fingerprint = hash.value();
    return card;
}

Json jsonOf(const GalleryCard& card) {
    return {{"name", card.name},
            {"group", card.group},
            {"title", card.title},
            {"purpose", card.purpose},
            {"file", card.file},
            {"seconds", card.seconds},
            {"posterTime", card.posterTime},
            {"bodies", card.bodies},
            {"joints", card.joints},
            {"hz", card.hz},
            {"frames", card.frames},
            {"fps", card.fps},
            {"width", card.width},
            {"height", card.height},
            {"fingerprint", hexText(card.fingerprint)},
            {"film", card.film},
            {"replay", card.replay}};
}

GalleryCard cardFrom(const Json& json) {
    GalleryCard card;
    for (const auto& [key, text] :
         {std::pair{"name", &card.name}, std::pair{"group", &card.group},
          std::pair{"title", &card.title}, std::pair{"purpose", &card.purpose},
          std::pair{"file", &card.file}})
        *text = json.at(key).get<std::string>();
    for (const auto& [key, number] :
         {std::pair{"bodies", &card.bodies}, std::pair{"joints", &card.joints},
          std::pair{"hz", &card.hz}, std::pair{"frames", &card.frames}, std::pair{"fps", &card.fps},
          std::pair{"width", &card.width}, std::pair{"height", &card.height}})
        *number = json.at(key).get<int>();
    card.seconds = json.at("seconds").get<double>();
    card.posterTime = json.at("posterTime").get<double>();
    card.fingerprint = std::stoull(json.at("fingerprint").get<std::string>(), nullptr, 16);
    card.film = json.at("film").get<bool>();
    card.replay = json.at("replay").get<bool>();
    return card;
}

}  // namespace demos
