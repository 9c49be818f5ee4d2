#include "demos/scene/every_key.h"

#include <utility>

#include "demos/text/complaints.h"

namespace demos {
namespace {

constexpr const char* kExampleBodies = R"(
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0, 2, 0]
[[body]]
name = "crate"
shape = { box = [1, 1, 1] }
at = [3, 2, 0]
)";

const KeyPart& allParts() {
    static const KeyPart all = [] {
        KeyPart sum;
        for (KeyPart part : {worldKeys(), bodyKeys(), jointKeys(), forceKeys(), filmKeys()}) {
            for (const KeyExample& example : part.examples) sum.examples.push_back(example);
            for (TableTexts& texts : part.texts) sum.texts.push_back(std::move(texts));
        }
        return sum;
    }();
    return all;
}

}  // namespace

const std::vector<KeyExample>& everyKey() { return allParts().examples; }

const std::vector<TableTexts>& everyText() { return allParts().texts; }

const KeyText* textOn(std::string_view table, std::string_view key) {
    for (const TableTexts& texts : everyText())
        for (const KeyText& text : texts.keys)
            if (texts.table == table && text.key == key) return &text;
    return nullptr;
}

std::string sceneOf(const KeyExample& example) {
    // The longest film allowed: it bounds the times in the schema.
    return std::string("format = 1\nseconds = 100000") + example.text + kExampleBodies;
}

std::string inToml(double value) { return numberText(value); }
std::string inToml(int value) { return std::to_string(value); }
std::string inToml(bool value) { return value ? "true" : "false"; }
std::string inToml(const engine::Vec3& value) {
    return "[" + numberText(value.x()) + ", " + numberText(value.y()) + ", " +
           numberText(value.z()) + "]";
}
std::string inToml(const std::string& value) { return "\"" + value + "\""; }

}  // namespace demos
