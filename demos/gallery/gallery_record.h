/// gallery.json: whose the files of a gallery's folder are, and what they were made of.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "demos/gallery/gallery_card.h"

namespace demos {

/// Of one scene. Before its first picture is written it is here without hashes: its files are ours.
struct GalleryEntry {
    std::uint64_t fingerprint = 0;       // GalleryCard's
    std::uint64_t poster = 0, film = 0;  // TextHash of the files; 0: not made
};

/// Scenes that a later command leaves out stay here, and their files where they are.
class GalleryRecord {
public:
    /// Of what is in the folder; a file that is not there, or not ours, is an empty record.
    explicit GalleryRecord(std::filesystem::path folder);

    /// Whether `NAME.png` and `NAME.mp4` are ours to replace.
    bool owns(const std::string& name) const { return entries_.count(name) > 0; }
    /// Whether there was a record: index.html and sheet.png are ours then.
    bool found() const { return found_; }
    /// Whole, of other settings, scene or program.
    bool isOutdated(const GalleryCard& card) const;
    /// Poster, and film where `film`, are there as they were written, of this fingerprint.
    bool has(const GalleryCard& card, bool film) const;

    void add(const std::string& name, const GalleryEntry& entry) { entries_[name] = entry; }
    std::uint64_t posterOf(const std::string& name) const;
    /// What the sheet was made of; 0: there is none.
    std::uint64_t sheet = 0;
    std::string command;  // that has written it last
    /// Throws render::Error.
    void write() const;

    std::filesystem::path posterFile(const std::string& name) const;
    std::filesystem::path filmFile(const std::string& name) const;
    std::filesystem::path pageFile() const { return folder_ / "index.html"; }
    std::filesystem::path sheetFile() const { return folder_ / "sheet.png"; }

private:
    std::filesystem::path folder_;
    std::map<std::string, GalleryEntry> entries_;
    bool found_ = false;
};

/// TextHash of a file's bytes; 0 where there is none.
std::uint64_t hashOfFile(const std::filesystem::path& file);

}  // namespace demos
