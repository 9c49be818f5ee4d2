#include "demos/regression/report_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/regression/report_film.h"
#include "demos/regression/report_images.h"
#include "demos/regression/verdict_json.h"
#include "demos/text/page_text.h"
#include "demos/text/script_safe.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

void addFilms(Json& page, const TestVerdict& verdict,
              const std::vector<ReportTrajectories>& trajectories) {
    const std::size_t count = std::min(trajectories.size(), verdict.scenes.size());
    const auto films =
        std::count_if(trajectories.begin(), trajectories.end(), [](const ReportTrajectories& c) {
            return !c.baseline.moments.empty() || !c.actual.moments.empty();
        });
    // 30 scenes of 15,000 numbers are about 2.5 MB; more scenes share the same total.
    const long numbers = std::min(15'000L, 450'000L / std::max(1L, static_cast<long>(films)));
    for (std::size_t i = 0; i < count; ++i)
        page["scenes"][i]["film"] = filmOf(trajectories[i], verdict.scenes[i].physics, numbers);
}

/// The folder for --results of `impulse approve`; empty: its default.
std::string resultsOption(const std::filesystem::path& folder) {
    std::string name = folder.lexically_normal().generic_string();
    while (name.size() > 1 && name.ends_with('/')) name.pop_back();
    return name == "output/test" ? "" : name;
}

}  // namespace

std::string reportPage(const TestVerdict& verdict,
                       const std::vector<ReportTrajectories>& trajectories,
                       const std::filesystem::path& folder, long bytes) {
    Json page = Json::parse(jsonOf(verdict));
    page["results"] = resultsOption(folder);
    for (std::size_t i = 0; i < verdict.scenes.size(); ++i)
        for (std::size_t k = 0; k < verdict.scenes[i].pictures.size(); ++k)
            page["scenes"][i]["pictures"][k]["name"] =
                pictureName(verdict.scenes[i].name, verdict.scenes[i].pictures[k].time);
    addFilms(page, verdict, trajectories);
    const PageText text = reportPageText();
    const std::string textAlone = scriptSafe(page);
    const long left =
        bytes - static_cast<long>(text.before.size() + textAlone.size() + text.after.size());
    addImages(page, verdict, folder, left);
    return text.before + scriptSafe(page) + text.after;
}

}  // namespace demos
