/// sections.json: what a folder of slides holds, for programs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// `files`: all that the folder is to hold.
std::string sectionsJson(const MadeDeck& deck, const std::vector<std::filesystem::path>& files);

/// The files that a run of 'impulse slides' has listed there; none where it has made nothing.
std::vector<std::filesystem::path> listedFiles(const std::filesystem::path& folder);

}  // namespace demos
