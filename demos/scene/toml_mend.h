/// What would mend a file that is not TOML: text without quotes, [body] instead of [[body]].
#pragma once
#include <string>
#include <string_view>

namespace demos {

/// The end of a message about line `line` (from 1): "; text is written in quotes: \"box\"". Empty
/// if the mistake is another. `what`: the parser's message.
std::string tomlMend(std::string_view text, int line, std::string_view what);

}  // namespace demos
