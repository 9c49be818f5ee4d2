/// A made deck as files, each whole or not at all.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// One page with everything in it.  (slides_page.cpp)
std::string slidesPage(const MadeDeck& deck);

/// index.html beside its films and pictures, notes.md, talk.tex (Beamer), talk.md (Marp),
/// sections.json. Returns their names.  (slides_folder.cpp)
std::vector<std::filesystem::path> writeSlidesFolder(const MadeDeck& deck,
                                                     const std::filesystem::path& folder);

/// A poster a page, by a headless Chromium. Throws render::Error, also where there is none: what to
/// install.  (slides_pdf.cpp)
void writeSlidesPdf(const MadeDeck& deck, const std::filesystem::path& file);

/// (beamer.cpp, marp.cpp, speaker_notes.cpp) `media`: how a slide's pictures and films are called
/// from there.
std::string beamerOf(const MadeDeck& deck);
std::string marpOf(const MadeDeck& deck);
std::string speakerNotesOf(const MadeDeck& deck);

}  // namespace demos
