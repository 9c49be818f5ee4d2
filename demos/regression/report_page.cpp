#include "demos/regression/report_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/regression/page_text.h"
#include "demos/regression/report_film.h"
#include "demos/regression/report_images.h"
#include "demos/regression/verdict_json.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

/// Inside <script> only "</script" and "<!--" mean anything to HTML, and JSON has no `<` outside of
/// its strings, where \u003c says the same. All else that is not ASCII is escaped too (U+2028).
std::string scriptSafe(const Json& json) {
    std::string safe;
    for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    return safe;
}

void addFilms(Json& page, const TestVerdict& verdict, const std::vector<ReportCourses>& courses) {
    const std::size_t count = std::min(courses.size(), verdict.scenes.size());
    const auto films = std::count_if(courses.begin(), courses.end(), [](const ReportCourses& c) {
        return !c.baseline.moments.empty() || !c.actual.moments.empty();
    });
    // 30 scenes of 15,000 numbers are about 2.5 MB; more scenes share them.
    const long numbers = std::min(15'000L, 450'000L / std::max(1L, static_cast<long>(films)));
    for (std::size_t i = 0; i < count; ++i)
        page["scenes"][i]["film"] = filmOf(courses[i], verdict.scenes[i].physics, numbers);
}

/// What `impulse approve` has to be told besides the names; empty: it looks there anyway.
std::string resultsOption(const std::filesystem::path& folder) {
    std::string name = folder.lexically_normal().generic_string();
    while (name.size() > 1 && name.ends_with('/')) name.pop_back();
    return name == "output/test" ? "" : name;
}

}  // namespace

std::string reportPage(const TestVerdict& verdict, const std::vector<ReportCourses>& courses,
                       const std::filesystem::path& folder, long bytes) {
    Json page = Json::parse(jsonOf(verdict));
    page["results"] = resultsOption(folder);
    for (std::size_t i = 0; i < verdict.scenes.size(); ++i)
        for (std::size_t k = 0; k < verdict.scenes[i].pictures.size(); ++k)
            page["scenes"][i]["pictures"][k]["name"] =
                pictureName(verdict.scenes[i].name, verdict.scenes[i].pictures[k].time);
    addFilms(page, verdict, courses);
    const std::string head = pageTextBeforeData(), tail = pageTextAfterData();
    const std::string textAlone = scriptSafe(page);
    const long left = bytes - static_cast<long>(head.size() + textAlone.size() + tail.size());
    addImages(page, verdict, folder, left);
    return head + scriptSafe(page) + tail;
}

}  // namespace demos
