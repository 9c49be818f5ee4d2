/// Lengths on paper, as given on the command line.
#pragma once
#include <optional>
#include <string>

namespace demos {

/// In mm, from "85mm", "8.5cm", "3.35in", "241pt" (72 per inch), or a plain number of mm. Nothing
/// for any other text, or if it is not finite.
std::optional<double> lengthFrom(const std::string& text);

}  // namespace demos
