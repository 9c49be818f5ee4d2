/// Lengths on paper, as a command line says them.
#pragma once
#include <optional>
#include <string>

namespace demos {

/// mm: "85mm", "8.5cm", "3.35in", "241pt" (72 an inch), or a plain number of mm. Nothing for what
/// is none of these, or not finite.
std::optional<double> lengthFrom(const std::string& text);

}  // namespace demos
