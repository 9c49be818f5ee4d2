#include "demos/comparisons/run_parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "demos/load/load_scene.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/hex_text.h"
#include "demos/text/json_limits.h"
#include "demos/text/program_bytes.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct PartOfRuns {
    PartSeen seen;
    std::vector<Summary> summaries;
};

fs::path fileOf(const RunsInParts& runs, const Shard& shard) {
    return runs.folder / (shard.name() + ".json");
}

/// JSON has no infinities: those are texts.
Json numberJson(double value) {
    return std::isfinite(value) ? Json(value) : Json(numberText(value));
}

double numberIn(const Json& json) {
    if (!json.is_string()) return json.get<double>();
    const auto text = json.get<std::string>();
    double value = 0.0;
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc())
        throw std::invalid_argument(text);
    return value;
}

Json jsonOf(const std::vector<double>& values) {
    Json all = Json::array();
    for (const double value : values) all.push_back(numberJson(value));
    return all;
}

std::vector<double> numbersOf(const Json& json, std::size_t count) {
    std::vector<double> values;
    for (const Json& value : json) values.push_back(numberIn(value));
    if (values.size() != count) throw std::invalid_argument("numbers");
    return values;
}

Json jsonOf(const Summary& summary, bool history) {
    Json json{{"values", jsonOf(summary.values)}, {"diverged", summary.diverged},
              {"failed", summary.failed}};
    if (!history) return json;
    json["time"] = jsonOf(summary.time);
    for (const std::vector<double>& values : summary.history)
        json["history"].push_back(jsonOf(values));
    return json;
}

Summary summaryFrom(const Json& json, bool history) {
    Summary summary;
    summary.values = numbersOf(json.at("values"), measures().size());
    json.at("diverged").get_to(summary.diverged);
    json.at("failed").get_to(summary.failed);
    if (!history) return summary;
    const Json& time = json.at("time");
    summary.time = numbersOf(time, time.size());
    for (const Json& values : json.at("history"))
        summary.history.push_back(numbersOf(values, time.size()));
    if (summary.history.size() != measures().size()) throw std::invalid_argument("history");
    return summary;
}

/// A record that cannot be read is seen, but not readable.
PartOfRuns partAt(const fs::path& file, const Shard& shard, bool history) try {
    PartOfRuns part{{shard, false, false, 0, "", ""}, {}};
    const std::vector<std::uint8_t> bytes = contentOf(file, kRunJson.bytes);
    const std::string text(bytes.begin(), bytes.end());
    checkJson(text, kRunJson);
    const Json json = Json::parse(text);
    part.seen.run = fromHex(json.at("run").get<std::string>()).value();
    json.at("impulse").get_to(part.seen.program);
    for (const Json& run : json.at("runs")) part.summaries.push_back(summaryFrom(run, history));
    part.seen.readable = part.seen.whole = true;
    return part;
} catch (const std::exception&) {
    return {{shard, false, false, 0, "", ""}, {}};
}

/// The number of runs that a part has of `count`.
std::size_t runsIn(const Shard& shard, std::size_t count) {
    std::size_t own = 0;
    for (std::size_t i = 0; i < count; ++i) own += isIn(shard, i) ? 1 : 0;
    return own;
}

}  // namespace

RunsInParts inParts(const RunsOptions& options, const std::string& name,
                    const std::vector<Variant>& variants, bool histories) {
    TextHash hash;
    hash.add(sceneText(options.scene()));
    for (const std::string& file : variants.front().scene.files) hash.add(contentOf(file));
    for (const std::string& setting : options.overrides) hash.add(setting);
    for (const Variant& variant : variants) {
        hash.add(variant.label);
        for (const std::string& setting : variant.settings) hash.add(setting);
    }
    hash.add(options.seconds ? numberText(*options.seconds) : "as long as the scene");
    hash.add(histories ? "histories" : "values");
    return {options.parts.empty() ? fs::path("output") / (name + ".parts")
                                  : fs::path(options.parts),
            hash.value(), histories};
}

bool isDone(const RunsInParts& runs, const Shard& shard, bool overwrite) {
    const PartOfRuns part = partAt(fileOf(runs, shard), shard, runs.histories);
    if (!part.seen.readable) return false;
    if (part.seen.run == runs.run && part.seen.program == programName()) return true;
    if (overwrite) return false;
    throw Stop(Exit::wouldOverwrite,
               "'" + printable(fileOf(runs, shard).string()) +
                   "' is of another run or program; --overwrite replaces it, --parts names "
                   "another folder");
}

void writePart(const RunsInParts& runs, const Shard& shard, const std::vector<Summary>& measured) {
    Json json{{"impulse", programName()}, {"run", hexText(runs.run)}, {"runs", Json::array()}};
    for (const Summary& summary : measured) json["runs"].push_back(jsonOf(summary, runs.histories));
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    render::makeFolder(runs.folder);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    render::writeFrameFile(fileOf(runs, shard), {bytes, text.size()});
}

RunsFound runsFound(const RunsInParts& runs, std::size_t count) {
    std::vector<PartOfRuns> parts;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(runs.folder, ignored))
        if (const std::optional<Shard> shard = shardNamed(entry.path().stem().string());
            shard && entry.path().extension() == ".json")
            parts.push_back(partAt(entry.path(), *shard, runs.histories));
    std::vector<PartSeen> seen;
    for (PartOfRuns& part : parts) {
        part.seen.whole = part.summaries.size() == runsIn(part.seen.shard, count);
        seen.push_back(part.seen);
    }
    RunsFound found{reviewed(seen, runs.folder.string(), runs.run), {}};
    if (!found.review.wanted.empty()) return found;
    for (std::size_t i = 0; i < count; ++i) {
        const auto among = static_cast<std::size_t>(found.review.count);
        found.summaries.push_back(parts[found.review.good[i % among]].summaries[i / among]);
    }
    return found;
}

}  // namespace demos
