/// A headless Chromium opens one page of a scratch folder, without a network.
#pragma once
#include <filesystem>
#include <string>

namespace demos {

/// Opens talk.html of `folder` and does `action`, an option such as "--dump-dom"; what it prints is
/// then in the folder's file "words". Returns how it failed, else "". Throws as runChild().
std::string browse(const std::string& program, const std::string& action,
                   const std::filesystem::path& folder);

/// `trouble` with the last line that the program printed.
std::string withLastWords(const std::string& trouble, const std::filesystem::path& folder);

}  // namespace demos
