#include "demos/regression/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/regression/scene_inputs.h"
#include "demos/regression/trajectory_codec.h"
#include "demos/text/base64.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/hex_text.h"
#include "demos/text/json_limits.h"
#include "demos/text/json_whole.h"
#include "demos/text/text_hash.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kBaselineFormat = 2, kOldestBaseline = 1;
constexpr std::size_t kMostTrajectory = 32 * 1024,
                      kMostBody = 200;  // bytes per trajectory, and more per body
constexpr const char* kAgain = "; accept the scene again with impulse test --update changed";

std::string jsonText(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

Json picturesJson(const Baseline& baseline) {
    Json pictures = Json::array();
    for (const BaselinePicture& picture : baseline.pictures)
        pictures.push_back({{"time", picture.time},
                            {"state", hexText(picture.state)},
                            {"png", hexText(picture.png)}});
    return pictures;
}

Json incidentsJson(const Baseline& baseline) {
    Json incidents = Json::array();
    for (const BaselineIncident& incident : baseline.incidents)
        incidents.push_back(
            {{"step", incident.step}, {"body", incident.body}, {"trouble", incident.trouble}});
    return incidents;
}

std::string trajectoryText(const Baseline& baseline, const Tolerance& tolerance) {
    if (!baseline.trajectoryText.empty()) return baseline.trajectoryText;
    const Trajectory& trajectory = baseline.trajectory;
    return toBase64(encodeTrajectory(trajectory, resolutionOf(trajectory, tolerance),
                                     kMostTrajectory + kMostBody * trajectory.bodies.size()));
}

Trajectory trajectoryFrom(const std::string& text) {
    const std::optional<std::string> bytes = fromBase64(text);
    if (!bytes) throw std::invalid_argument("base64");
    std::optional<Trajectory> trajectory =
        decodeTrajectory({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()});
    if (!trajectory) throw std::invalid_argument("course");
    return std::move(*trajectory);
}

Baseline baselineOf(const Json& json) {
    Baseline baseline;
    json.at("scene").get_to(baseline.scene);
    baseline.home = json.value("home", "");
    json.at("impulse").get_to(baseline.version);
    json.at("renderer").get_to(baseline.renderer);
    json.at("pixels").get_to(baseline.pixels);
    wholeTo(json.at("size").at(0), baseline.width);
    wholeTo(json.at("size").at(1), baseline.height);
    for (const auto& [key, value] : json.at("settings").items())
        baseline.settings.emplace_back(key, value.get<std::string>());
    for (const Json& picture : json.at("pictures"))
        baseline.pictures.push_back({picture.at("time").get<double>(),
                                     fromHex(picture.at("state").get<std::string>()).value(),
                                     fromHex(picture.at("png").get<std::string>()).value()});
    if (json.contains("inputs"))
        baseline.inputs = inflatedInputs(json["inputs"].get<std::string>());
    json.at("course").get_to(baseline.trajectoryText);
    baseline.trajectory = trajectoryFrom(baseline.trajectoryText);
    for (const Json& incident : json.value("incidents", Json::array()))
        baseline.incidents.push_back({wholeIn<long long>(incident.at("step")),
                                      incident.at("body").get<std::string>(),
                                      incident.at("trouble").get<std::string>()});
    return baseline;
}

}  // namespace

std::string pictureFile(double time) { return "t" + numberText(time) + ".png"; }

std::string jsonOf(const Baseline& baseline, const Tolerance& tolerance) {
    Json json{{"format", kBaselineFormat}, {"impulse", baseline.version},
              {"scene", baseline.scene},   {"renderer", baseline.renderer},
              {"pixels", baseline.pixels}, {"size", {baseline.width, baseline.height}}};
    if (!baseline.home.empty()) json["home"] = baseline.home;
    Json& settings = json["settings"] = Json::object();
    for (const auto& [key, value] : baseline.settings) settings[key] = value;
    if (!baseline.inputs.empty()) json["inputs"] = deflatedInputs(baseline.inputs);
    json["pictures"] = picturesJson(baseline);
    json["course"] = trajectoryText(baseline, tolerance);
    if (!baseline.incidents.empty()) json["incidents"] = incidentsJson(baseline);
    json["seal"] = hexText(hashOf(jsonText(json)));
    return jsonText(json) + "\n";
}

Baseline baselineFrom(const std::string& text, const std::string& name) try {
    checkJson(text, kBaselineJson);
    Json json = Json::parse(text);
    if (const int format = wholeIn<int>(json.at("format")); format < kOldestBaseline || format > kBaselineFormat)
        throw BaselineError(fmt::format(
            "{} has format {}, but this impulse reads {}; {}", name, format, kBaselineFormat,
            format > kBaselineFormat ? "use a newer impulse" : "accept the scene again"));
    const std::uint64_t seal = fromHex(json.at("seal").get<std::string>()).value();
    json.erase("seal");
    if (seal != hashOf(jsonText(json)))
        throw BaselineError(name + " was edited: its seal does not match its content" + kAgain);
    return baselineOf(json);
} catch (const BaselineError&) {
    throw;
} catch (const std::exception&) {
    throw BaselineError(name + " is damaged, or not a baseline of impulse test" + kAgain);
}

std::optional<Baseline> readBaseline(const fs::path& folder) {
    const fs::path file = folder / kBaselineFile;
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) return std::nullopt;
    const std::vector<std::uint8_t> bytes = contentOf(file, kBaselineJson.bytes);
    return baselineFrom({bytes.begin(), bytes.end()}, printable(file.string()));
}

std::vector<std::uint8_t> readPicture(const fs::path& folder, const BaselinePicture& picture) {
    const fs::path file = folder / pictureFile(picture.time);
    std::vector<std::uint8_t> bytes = contentOf(file, kMostPictureBytes);
    if (bytes.empty())
        throw BaselineError(printable(file.string()) + " is missing, empty or above 256 MiB" +
                            kAgain);
    const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    if (text.starts_with("version https://git-lfs"))
        throw BaselineError(printable(file.string()) +
                            " is a pointer of Git LFS; fetch the file with git lfs pull");
    if (hashOf(bytes) != picture.png)
        throw BaselineError(printable(file.string()) + " does not match " + kBaselineFile +
                            " next to it: it is truncated, or from another baseline" + kAgain);
    return bytes;
}

std::vector<std::string> orphansOf(const fs::path& folder, const std::vector<double>& times) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const auto isOf = [&name](double time) { return pictureFile(time) == name; };
        if (name.ends_with(".png") && std::none_of(times.begin(), times.end(), isOf))
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace demos
