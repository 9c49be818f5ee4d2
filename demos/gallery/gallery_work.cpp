#include "demos/gallery/gallery_work.h"

#include <nlohmann/json.hpp>

#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/put_text.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

std::string failure(Exit code, const std::vector<std::string>& lines) {
    const Json json{{"code", static_cast<int>(code)}, {"lines", lines}};
    return "-" + json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A line about a file begins with the file, all others with the scene.
void putLine(const std::string& name, const std::string& line, bool ofFile) {
    const bool named = ofFile || line.starts_with(name + ":");
    putError((named ? "" : printable(name) + ": ") + printable(line));
}

}  // namespace

std::string attempted(const std::function<std::string()>& work) noexcept {
    try {
        return "+" + work();
    } catch (const Stop& stop) {
        return failure(stop.code(), {stop.what()});
    } catch (const SceneError& error) {
        return failure(Exit::scene, error.lines());
    } catch (const std::exception& error) {
        return failure(Exit::environment, {error.what()});
    }
}

std::optional<std::string> textOf(const PoolResult& result) {
    if (!result.ended || !result.text.starts_with('+')) return std::nullopt;
    return result.text.substr(1);
}

bool GalleryTroubles::take(const GalleryChoice& choice, const PoolResult& result,
                           std::string& text) {
    if (const std::optional<std::string> given = textOf(result)) {
        text = *given;
        return true;
    }
    if (!result.ended) {
        tell(choice.name, {"the process that drew it " + result.text}, Exit::environment);
        return false;
    }
    const Json json = Json::parse(result.text.substr(1));
    const auto lines = json.at("lines").get<std::vector<std::string>>();
    const auto code = static_cast<Exit>(json.at("code").get<int>());
    if (code == Exit::usage) throw Stop(code, lines.front());  // of the command, so of all scenes
    tell(choice.name, lines, code);
    return false;
}

void GalleryTroubles::tellIncident(const std::string& name, const std::string& line) {
    if (line.empty()) return;
    if (code_ == Exit::ok) code_ = Exit::diverged;
    const Json json{{"event", "incident"}, {"scene", name}, {"text", line}};
    talk_.json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
    putLine(name, line, false);
}

/// Reports with --quiet too.
void GalleryTroubles::tell(const std::string& name, const std::vector<std::string>& lines,
                           Exit code) {
    if (++count_ == 1) code_ = code;
    Json json{{"event", "failed"}, {"scene", name}, {"lines", lines}};
    talk_.json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
    for (const std::string& line : lines) putLine(name, line, code == Exit::scene);
}

}  // namespace demos
