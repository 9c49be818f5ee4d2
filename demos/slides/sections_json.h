/// sections.json: the content of a folder of slides, for programs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// `files`: all files of the folder.
std::string sectionsJson(const MadeDeck& deck, const std::vector<std::filesystem::path>& files);

/// The files that 'impulse slides' has listed in the folder; empty if it has made none.
std::vector<std::filesystem::path> listedFiles(const std::filesystem::path& folder);

}  // namespace demos
