/// Protects scene files from being overwritten by a command's output.
#pragma once
#include <string>
#include <vector>

namespace demos {

/// Throws Stop (usage) if a target is one of the scenes. Empty targets are ignored.
void spareScenes(const std::vector<std::string>& scenes, const std::vector<std::string>& targets);

enum class ResultKind { table, events, chart };

/// A result replaces an earlier one of its kind, and nothing else: throws Stop (wouldOverwrite) if another file is
/// there. Empty targets and "-" are ignored.
void spareOthers(ResultKind kind, const std::vector<std::string>& targets);

}  // namespace demos
