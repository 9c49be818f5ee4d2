/// Small scenes that together use every key of the format: the source of the schema. A key of the
/// reader that none of them uses is found by tests/demos/scene/schema_test.cpp and
/// tests/docs/scene_format_test.cpp.
#pragma once
#include <span>
#include <string>

namespace demos {

struct KeyExample {
    const char* what;
    const char*
        text;  // without `format` and `seconds`; it may use the bodies 'floor', 'ball' and 'crate'
    bool namesFiles = false;  // of missing files: the reader reports them and nothing else
};

std::span<const KeyExample> everyKey();

/// The whole scene.
std::string sceneOf(const KeyExample& example);

}  // namespace demos
