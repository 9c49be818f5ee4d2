/// Small scenes that together use every key of the format, and a sentence on every key: the source
/// of the schema and of `impulse list --explain`. A key of the reader that none of the scenes uses
/// is found by tests/demos/scene/schema_test.cpp and tests/docs/scene_format_test.cpp, one without
/// a sentence or with a wrong default by tests/demos/scene/every_key_test.cpp.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/math.h"

namespace demos {

struct KeyExample {
    const char* what;
    const char*
        text;  // without `format` and `seconds`; it may use the bodies 'floor', 'ball' and 'crate'
    bool namesFiles = false;  // of missing files: the reader reports them and nothing else
};

struct KeyText {
    const char* key;       // "*": any name
    std::string usual;     // its default, as in a scene; in words if it is computed or "required"
    const char* sentence;  // what it is and when to change it; unit and range come from the reader
};

struct TableTexts {
    const char* table;  // its name in messages: "[world]", "a [[body]]"
    std::vector<KeyText> keys;
};

/// One part of the format; each is defined in every_key_PART.cpp.
struct KeyPart {
    std::vector<KeyExample> examples;
    std::vector<TableTexts> texts;
};
KeyPart worldKeys();
KeyPart bodyKeys();
KeyPart jointKeys();
KeyPart forceKeys();
KeyPart filmKeys();

/// The examples of all parts.
const std::vector<KeyExample>& everyKey();
/// The sentences of all parts.
const std::vector<TableTexts>& everyText();
/// The text on a key of a table; null if there is none.
const KeyText* textOn(std::string_view table, std::string_view key);

/// The whole scene.
std::string sceneOf(const KeyExample& example);

/// Values as they are written in a scene.
std::string inToml(double value);
std::string inToml(int value);
std::string inToml(bool value);
std::string inToml(const engine::Vec3& value);
std::string inToml(const std::string& value);

}  // namespace demos
