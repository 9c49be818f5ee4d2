#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>

#include "demos/file_content.h"
#include "demos/film/outputs.h"
#include "demos/scene/complaints.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/linked_page.h"
#include "demos/slides/sections_json.h"
#include "demos/slides/slide_media.h"
#include "demos/stop.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<std::uint8_t>;

/// Made when it is its turn: all films of a talk need not be in memory at once.
struct FolderFile {
    fs::path name;  // in the folder
    std::function<Bytes()> content;
};

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

Bytes filmBytes(const fs::path& film) {
    Bytes bytes = contentOf(film);
    if (bytes.empty()) throw render::Error("cannot read '" + film.string() + "'");
    return bytes;
}

void addMedia(const MadeSlide& slide, std::vector<FolderFile>& files) {
    if (hasFilm(slide))
        files.push_back({filmName(slide), [&slide] { return filmBytes(slide.film->file); }});
    const std::vector<const MadePicture*> pictures = picturesOf(slide);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const MadePicture* picture = pictures[i];
        files.push_back({pictureName(slide, i), [picture] { return picture->png; }});
        if (!picture->svg.empty())
            files.push_back(
                {pictureName(slide, i, "svg"), [picture] { return bytesOf(picture->svg); }});
    }
}

/// sections.json comes first: whatever becomes of the others, it knows them as its own.
std::vector<FolderFile> wordFiles(const MadeDeck& deck) {
    return {{"sections.json", {}},
            {"index.html", [&deck] { return bytesOf(linkedSlidesPage(deck)); }},
            {"notes.md", [&deck] { return bytesOf(speakerNotesOf(deck)); }},
            {"talk.tex", [&deck] { return bytesOf(beamerOf(deck)); }},
            {"talk.md", [&deck] { return bytesOf(marpOf(deck)); }}};
}

std::vector<FolderFile> filesOf(const MadeDeck& deck) {
    std::vector<FolderFile> files = wordFiles(deck);
    for (const MadeSlide& slide : deck.slides) addMedia(slide, files);
    std::vector<fs::path> names;
    for (const FolderFile& file : files) names.push_back(file.name);
    files.front().content = [&deck, names] { return bytesOf(sectionsJson(deck, names)); };
    return files;
}

bool isAmong(const fs::path& name, const std::vector<fs::path>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// What a slides run has not made is not its to replace.
void checkStrangers(const fs::path& folder, const std::vector<FolderFile>& files,
                    const std::vector<fs::path>& own) {
    for (const FolderFile& file : files) {
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(folder / file.name, ignored))) continue;
        if (!isAmong(file.name, own))
            throw Stop(Exit::wouldOverwrite,
                       fmt::format("'{}' was not made by impulse slides; remove it or write to "
                                   "another folder",
                                   printable((folder / file.name).string())));
        render::checkReplaceable(folder / file.name);
    }
}

/// All of it beside the folder, until it is whole.
class Draft {
public:
    explicit Draft(const fs::path& folder) : path_(render::temporaryNameFor(folder)) {
        fs::remove_all(path_);  // of a killed run with our number
        makeFolder(path_ / "media");
    }
    ~Draft() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    void write(const FolderFile& file) const {
        render::writeFileAtomically(path_ / file.name, file.content());
    }
    void moveTo(const fs::path& folder, const FolderFile& file) const {
        std::error_code error;
        fs::rename(path_ / file.name, folder / file.name, error);
        if (error)
            throw render::Error("cannot write '" + (folder / file.name).string() +
                                "': " + error.message());
    }

private:
    fs::path path_;
};

fs::path withoutSlash(const fs::path& folder) {
    return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

void checkSlidesFolder(const fs::path& target, bool overwrite) {
    const fs::path folder = withoutSlash(target);
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(folder, ignored))) return;
    if (!fs::is_directory(folder, ignored))
        throw render::Error("cannot write '" + folder.string() + "': it is no folder");
    if (!overwrite && !fs::is_empty(folder, ignored))
        throw Stop(Exit::wouldOverwrite,
                   fmt::format("'{}' has files already; --overwrite replaces those that impulse "
                               "slides made",
                               printable(folder.string())));
    checkStrangers(folder, wordFiles(MadeDeck{}), listedFiles(folder));
}

std::vector<fs::path> writeSlidesFolder(const MadeDeck& deck, const fs::path& target) {
    const fs::path folder = withoutSlash(target);
    const std::vector<FolderFile> files = filesOf(deck);
    const std::vector<fs::path> own = listedFiles(folder);
    checkStrangers(folder, files, own);
    makeFolder(folder.parent_path());
    const Draft draft(folder);
    for (const FolderFile& file : files) draft.write(file);
    makeFolder(folder / "media");
    std::vector<fs::path> names;
    for (const FolderFile& file : files) {
        draft.moveTo(folder, file);
        names.push_back(file.name);
    }
    for (const fs::path& name : own) {
        std::error_code ignored;
        if (!isAmong(name, names)) fs::remove(folder / name, ignored);
    }
    return names;
}

}  // namespace demos
