/// Small scenes that use every key of the format at least once: what the schema is made of. A key
/// of the reader that none of them uses is found by tests/demos/scene/schema_test.cpp and
/// tests/docs/schema_test.cpp.
#pragma once
#include <span>
#include <string>

namespace demos {

struct KeyExample {
    const char* what;
    const char*
        text;  // without `format` and `seconds`; it may use the bodies 'floor', 'ball' and 'crate'
    bool namesFiles = false;  // that are not there: the reader complains of them, and of them alone
};

std::span<const KeyExample> everyKey();

/// The whole scene.
std::string sceneOf(const KeyExample& example);

}  // namespace demos
