#include "demos/regression/junit.h"

#include <fmt/format.h>

#include "demos/regression/verdict_text.h"
#include "demos/regression/xml_element.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

/// Why a case failed: one line, then details.
struct Fault {
    const char* type;
    std::string message;
    std::vector<std::string> details;
};

/// Counts of an element's cases, which become its attributes.
struct Counts {
    int tests = 0, failures = 0, errors = 0, skipped = 0;

    Counts& operator+=(const Counts& more) {
        tests += more.tests;
        failures += more.failures;
        errors += more.errors;
        skipped += more.skipped;
        return *this;
    }
};

void set(XmlElement& node, const char* name, const std::string& text) {
    node.set(name, printable(text));
}

void writeCounts(const Counts& counts, XmlElement& node) {
    node.set("tests", std::to_string(counts.tests));
    node.set("failures", std::to_string(counts.failures));
    node.set("errors", std::to_string(counts.errors));
    node.set("skipped", std::to_string(counts.skipped));
}

void writeLines(const std::vector<std::string>& lines, XmlElement& node) {
    std::string text;
    for (const std::string& line : lines)
        text.append(text.empty() ? "" : "\n").append(printable(line));
    node.setText(std::move(text));
}

/// The message is also the first line of the text: GitLab does not read the attribute.
void writeFault(const Fault& fault, const char* element, XmlElement& testCase) {
    XmlElement& node = testCase.add(element);
    set(node, "message", fault.message);
    set(node, "type", fault.type);
    std::vector<std::string> lines{fault.message};
    lines.insert(lines.end(), fault.details.begin(), fault.details.end());
    writeLines(lines, node);
}

std::vector<std::string> settingLines(const std::vector<SettingChange>& settings) {
    std::vector<std::string> lines;
    for (const SettingChange& change : settings)
        lines.push_back("made with another setting: " + settingText(change));
    return lines;
}

Fault faultOf(const ExpectationResult& result) {
    Fault fault{"expectation", "measured " + cameOut(result), {}};
    if (!result.why.empty()) fault.details.push_back("why: " + result.why);
    return fault;
}

/// The message where there is nothing to compare with; `problem`: with the baseline, if any.
std::string missing(const char* what, const std::string& problem) {
    if (!problem.empty()) return problem;
    return fmt::format("there is no baseline of {}", what);
}

Fault physicsFault(const SceneVerdict& scene) {
    const std::vector<std::string>& lines = scene.physics.lines;
    Fault fault{"physics", "the bodies move differently than in the baseline",
                settingLines(scene.settings)};
    if (scene.physics.kind == PhysicsVerdict::Kind::unknown) {
        fault.message = missing("the physics", scene.problem);
    } else if (!lines.empty()) {
        fault.message = lines.front();
        fault.details.insert(fault.details.begin(), lines.begin() + 1, lines.end());
    }
    return fault;
}

std::vector<std::string> fileLines(const PictureVerdict& picture) {
    std::vector<std::string> lines;
    if (!picture.baseline.empty()) lines.push_back("baseline: " + picture.baseline);
    if (!picture.actual.empty()) lines.push_back("actual: " + picture.actual);
    return lines;
}

Fault faultOf(const PictureVerdict& picture, const SceneVerdict& scene) {
    Fault fault{"picture", picture.problem, fileLines(picture)};
    if (picture.kind == PictureVerdict::Kind::changed)
        fault.message = differenceText(picture.difference, scene.snapshot.gate);
    else if (picture.problem.empty())
        fault.message = missing("this picture", scene.problem);
    if (picture.baselineState != 0 && picture.baselineState != picture.state)
        fault.details.push_back("the state of the world differs from that in the baseline");
    return fault;
}

class SceneSuite {
public:
    SceneSuite(const SceneVerdict& scene, XmlElement& node) : scene_(scene), node_(node) {}

    Counts write() {
        set(node_, "name", scene_.name);
        if (scene_.state == SceneVerdict::State::error)
            addError();
        else if (scene_.cached)
            addSkipped();
        else
            addCases();
        writeCounts(counts_, node_);
        if (!scene_.orphans.empty()) writeOrphans();
        return counts_;
    }

private:
    void addCases() {
        for (const ExpectationResult& result : scene_.expectations) add(result);
        if (comparesPhysics()) addPhysics();
        for (const PictureVerdict& picture : scene_.pictures) add(picture);
    }

    /// A scene without pictures has expectations but no baseline.
    bool comparesPhysics() const {
        return scene_.physics.kind != PhysicsVerdict::Kind::unknown || !scene_.pictures.empty();
    }

    void addSkipped() {
        const std::string message = "nothing has changed since it passed";
        XmlElement& reason = testCase(scene_.name).add("skipped");
        set(reason, "message", message);
        writeLines({message}, reason);
        ++counts_.skipped;
    }

    void addError() {
        writeFault({"scene", scene_.problem, {}}, "error", testCase(scene_.name));
        ++counts_.errors;
    }

    void add(const ExpectationResult& result) {
        XmlElement& node = testCase("expect: " + result.text);
        if (!result.passed) fail(faultOf(result), node);
    }

    void addPhysics() {
        XmlElement& node = testCase(scene_.name + "@physics");
        const PhysicsVerdict& physics = scene_.physics;
        if (failed() && !physics.passes())
            fail(physicsFault(scene_), node);
        else if (!physics.lines.empty())
            writeLines(physics.lines, node.add("system-out"));
    }

    void add(const PictureVerdict& picture) {
        XmlElement& node = testCase(pictureName(scene_.name, picture.time));
        if (failed() && !picture.passes()) {
            fail(faultOf(picture, scene_), node);
            if (!picture.actual.empty()) attach(picture.actual, node);
        } else if (picture.kind == PictureVerdict::Kind::within) {
            writeLines({differenceText(picture.difference, scene_.snapshot.gate)},
                       node.add("system-out"));
        }
    }

    /// GitLab and Jenkins show the file that a line of this form names.
    static void attach(const std::string& file, XmlElement& node) {
        writeLines({"[[ATTACHMENT|" + file + "]]"}, node.add("system-out"));
    }

    void writeOrphans() {
        std::vector<std::string> lines;
        for (const std::string& orphan : scene_.orphans)
            lines.push_back("no listed time uses " + orphan);
        writeLines(lines, node_.add("system-out"));
    }

    XmlElement& testCase(const std::string& name) {
        XmlElement& node = node_.add("testcase");
        set(node, "classname", scene_.name);
        set(node, "name", name);
        if (scene_.scene != scene_.name) set(node, "file", scene_.scene);
        ++counts_.tests;
        return node;
    }

    void fail(const Fault& fault, XmlElement& node) {
        writeFault(fault, "failure", node);
        ++counts_.failures;
    }

    /// In a scene that was added or updated nothing fails: the actual is its new baseline.
    bool failed() const { return scene_.state == SceneVerdict::State::failed; }

    const SceneVerdict& scene_;
    XmlElement& node_;
    Counts counts_;
};

}  // namespace

std::string junitXml(const TestVerdict& verdict) {
    XmlElement root("testsuites");
    root.set("name", "impulse");
    Counts counts;
    for (const SceneVerdict& scene : verdict.scenes)
        counts += SceneSuite(scene, root.add("testsuite")).write();
    writeCounts(counts, root);
    return root.document();
}

}  // namespace demos
