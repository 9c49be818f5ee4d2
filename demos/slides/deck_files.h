/// A made deck as files, each whole or not at all.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// One page with everything in it. Throws render::Error where a film cannot be read, FormulaError.
/// (slides_page.cpp)
std::string slidesPage(const MadeDeck& deck);

/// index.html beside its films and pictures in media/, notes.md, talk.tex (Beamer), talk.md (Marp),
/// sections.json. Returns their names. Replaces and removes only what a slides run has made, as
/// sections.json lists it; throws Stop (wouldOverwrite) for others in their place, before anything
/// is changed; without `overwrite` also for a folder that has files; render::Error.
/// (slides_folder.cpp)
std::vector<std::filesystem::path> writeSlidesFolder(const MadeDeck& deck,
                                                     const std::filesystem::path& folder,
                                                     bool overwrite = true);

/// What of this can be known before a deck is made: throws Stop (wouldOverwrite) where the folder
/// has files and may not be written to.  (slides_folder.cpp)
void checkSlidesFolder(const std::filesystem::path& folder, bool overwrite);

/// A poster a page, by a headless Chromium; whole or not at all. Throws render::Error, also where
/// there is none: what to install.  (slides_pdf.cpp)
void writeSlidesPdf(const MadeDeck& deck, const std::filesystem::path& file);

/// The program that prints it; empty where PATH has none.
std::string pdfBrowser();

/// With media/ beside them.  (beamer.cpp, marp.cpp, speaker_notes.cpp)
std::string beamerOf(const MadeDeck& deck);
std::string marpOf(const MadeDeck& deck);
std::string speakerNotesOf(const MadeDeck& deck);

}  // namespace demos
