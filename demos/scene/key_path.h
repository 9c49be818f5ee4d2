/// The keys of a scene as the command line names them: world.hz, body.ball.mass, body.box[3].mass
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace demos {

/// The parts between the dots; a part in quotes may contain dots.
std::vector<std::string> keyParts(std::string_view path);

/// box[3]; the index counts from 0.
struct IndexedPart {
    std::string name;
    std::size_t index = 0;
};
/// Nothing if the part has no index.
std::optional<IndexedPart> indexedPart(const std::string& part);

/// The whole text as a number that counts from 0; nothing if it is none.
std::optional<std::size_t> indexNumber(std::string_view text);

}  // namespace demos
