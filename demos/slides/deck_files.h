/// Writes a made deck as files, each complete or not at all.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"
#include "render/encode/file.h"

namespace demos {

/// One page with everything embedded. Throws FormulaError; render::Error if a film cannot be read.
/// (slides_page.cpp)
std::string slidesPage(const MadeDeck& deck);

/// Writes index.html, its films and pictures in media/, notes.md, talk.tex (Beamer), talk.md (Marp)
/// and sections.json. Returns their names. Replaces and removes only files that a slides run has
/// made, which sections.json lists. Throws Stop (wouldOverwrite), before anything is changed, if
/// another file has one of the names or, without `overwrite`, if the folder has files;
/// render::Error.
/// (slides_folder.cpp)
std::vector<std::filesystem::path> writeSlidesFolder(const MadeDeck& deck,
                                                     const std::filesystem::path& folder,
                                                     bool overwrite = true);

/// Checks what is possible before a deck is made: throws Stop (wouldOverwrite) if the folder has
/// files that must not be replaced.  (slides_folder.cpp)
void checkSlidesFolder(const std::filesystem::path& folder, bool overwrite);

/// Prints the deck with posters by a headless Chromium; complete or not at all. Throws
/// render::Error; without Chromium it says what to install.  (slides_pdf.cpp)
void writeSlidesPdf(const MadeDeck& deck, const std::filesystem::path& file, render::Existing existing);

/// A presentation for PowerPoint and Impress: words as text, formulas as pictures with their LaTeX,
/// films that start on a click. A headless Chromium says where its parts are. Complete or not at
/// all; the same deck gives the same bytes. Throws as writeSlidesPdf().  (slides_pptx.cpp)
void writeSlidesPptx(const MadeDeck& deck, const std::filesystem::path& file, render::Existing existing);

/// The program that prints the PDF and lays out a .pptx; empty if PATH has none.
std::string pdfBrowser();

/// Texts that refer to media/ next to them.  (beamer.cpp, marp.cpp, speaker_notes.cpp)
std::string beamerOf(const MadeDeck& deck);
std::string marpOf(const MadeDeck& deck);
std::string speakerNotesOf(const MadeDeck& deck);

}  // namespace demos
