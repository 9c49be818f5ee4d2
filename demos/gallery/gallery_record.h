/// gallery.json: which files of a folder are the gallery's, and their inputs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "demos/gallery/gallery_card.h"

namespace demos {

/// One scene. Added without hashes before its first picture is written: its files are then ours.
struct GalleryEntry {
    std::uint64_t fingerprint = 0;                   // GalleryCard's
    std::uint64_t poster = 0, film = 0, replay = 0;  // TextHash of the files; 0: not made
    std::string incident;  // of its simulation (Player::incident); empty: none
};

/// Which files a gallery makes of each scene besides its poster.
struct GalleryKinds {
    bool films = true, replays = true;
};

/// Keeps scenes that a later command leaves out, and their files.
class GalleryRecord {
public:
    /// Reads the folder's record; empty if there is none or it cannot be read.
    explicit GalleryRecord(std::filesystem::path folder);

    /// Whether `NAME.png`, `NAME.mp4` and `NAME.html` are ours to replace.
    bool owns(const std::string& name) const { return entries_.count(name) > 0; }
    /// Whether there was a record: index.html and sheet.png are ours then.
    bool found() const { return found_; }
    /// Whether it was drawn with other settings, scene or program.
    bool isOutdated(const GalleryCard& card) const;
    /// Whether the poster, and what else is made, exist unchanged with this fingerprint.
    bool has(const GalleryCard& card, const GalleryKinds& made) const;

    void add(const std::string& name, const GalleryEntry& entry) { entries_[name] = entry; }
    std::uint64_t posterOf(const std::string& name) const;
    std::string incidentOf(const std::string& name) const;
    /// Hash of the sheet's inputs; 0: there is no sheet.
    std::uint64_t sheet = 0;
    std::string command;  // the last that wrote it
    /// Throws render::Error.
    void write() const;

    std::filesystem::path posterFile(const std::string& name) const;
    std::filesystem::path filmFile(const std::string& name) const;
    std::filesystem::path replayFile(const std::string& name) const;
    std::filesystem::path pageFile() const { return folder_ / "index.html"; }
    std::filesystem::path sheetFile() const { return folder_ / "sheet.png"; }

private:
    std::filesystem::path folder_;
    std::map<std::string, GalleryEntry> entries_;
    bool found_ = false;
};

}  // namespace demos
