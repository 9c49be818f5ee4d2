#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <optional>
#include <set>
#include <string_view>

#include "demos/film/outputs.h"
#include "demos/processes/folder_lock.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/linked_page.h"
#include "demos/slides/sections_json.h"
#include "demos/slides/slide_media.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<std::uint8_t>;

/// The content is made when the file is written, so that only one film is in memory at a time.
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

constexpr const char* kList = "sections.json";

/// All text files except the list.
std::vector<FolderFile> wordFiles(const MadeDeck& deck) {
    return {{"index.html", [&deck] { return bytesOf(linkedSlidesPage(deck)); }},
            {"notes.md", [&deck] { return bytesOf(speakerNotesOf(deck)); }},
            {"talk.tex", [&deck] { return bytesOf(beamerOf(deck)); }},
            {"talk.md", [&deck] { return bytesOf(marpOf(deck)); }}};
}

std::vector<FolderFile> filesOf(const MadeDeck& deck) {
    std::vector<FolderFile> files = wordFiles(deck);
    for (const MadeSlide& slide : deck.slides) addMedia(slide, files);
    return files;
}

std::vector<fs::path> namesOf(const std::vector<FolderFile>& files) {
    std::vector<fs::path> names{kList};
    for (const FolderFile& file : files) names.push_back(file.name);
    return names;
}

using Names = std::set<fs::path>;

Names setOf(const std::vector<fs::path>& names) { return {names.begin(), names.end()}; }

/// With a symbolic link films would be written, and files removed, outside of the folder.
void checkMediaFolder(const fs::path& folder) {
    std::error_code ignored;
    const fs::file_status media = fs::symlink_status(folder / "media", ignored);
    if (!fs::exists(media) || fs::is_directory(media)) return;
    throw render::Error(
        fmt::format("cannot write into '{}': it is not a folder; remove it or write to another "
                    "folder",
                    printable((folder / "media").string())));
}

/// Throws if a file with one of the names was not made by a slides run.
void checkStrangers(const fs::path& folder, const std::vector<fs::path>& names,
                    const std::vector<fs::path>& own) {
    checkMediaFolder(folder);
    const Names ours = setOf(own);
    for (const fs::path& name : names) {
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(folder / name, ignored))) continue;
        if (!ours.contains(name))
            throw Stop(Exit::wouldOverwrite,
                       fmt::format("'{}' was not made by impulse slides; remove it or write to "
                                   "another folder",
                                   printable((folder / name).string())));
        render::checkReplaceable(folder / name);
    }
}

/// Within the folder, which may be on another disk: rename does not work across disks.
constexpr std::string_view kDraft = ".impulse-slides.tmp";

bool isDraft(const fs::path& name) {
    const std::string text = name.filename().string();
    return text.starts_with(kDraft) &&
           text.find_first_not_of("0123456789", kDraft.size()) == std::string::npos;
}

/// Removes drafts of killed runs; the folder's lock ensures that no run is writing them.
void sweepDrafts(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (isDraft(entry.path())) fs::remove_all(entry.path(), ignored);
}

bool isEmpty(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (!isDraft(entry.path())) return false;
    return true;
}

/// Whether a run failed or was killed between its list and its last file: the next one finishes it.
bool isUnfinished(const fs::path& folder) {
    const std::vector<fs::path> own = listedFiles(folder);
    return std::any_of(own.begin(), own.end(), [&folder](const fs::path& name) {
        std::error_code ignored;
        return !fs::exists(fs::symlink_status(folder / name, ignored));
    });
}

void checkEmpty(const fs::path& folder, bool overwrite) {
    if (!overwrite && !isEmpty(folder) && !isUnfinished(folder))
        throw Stop(Exit::wouldOverwrite,
                   fmt::format("'{}' has files already; --overwrite replaces those that impulse "
                               "slides made",
                               printable(folder.string())));
}

/// Reserves the folder for one run; creates it if necessary, and removes it then if it stays empty.
class Claim {
public:
    explicit Claim(const fs::path& folder) : folder_(folder), made_(!fs::exists(folder)) {
        render::makeFolder(folder);
        lock_.emplace(folder);
        sweepDrafts(folder);
    }
    ~Claim() {
        if (made_) ::rmdir(folder_.c_str());  // fails if there are files
    }
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

private:
    fs::path folder_;
    bool made_;
    std::optional<FolderLock> lock_;
};

/// All files, until they are complete.
class Draft {
public:
    explicit Draft(const fs::path& folder)
        : folder_(folder), path_(folder / (std::string(kDraft) + std::to_string(getpid()))) {
        render::makeFolder(path_ / "media");
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
    void publish(const fs::path& name) const {
        std::error_code error;
        fs::rename(path_ / name, folder_ / name, error);
        if (error)
            throw render::Error("cannot write '" + (folder_ / name).string() +
                                "': " + error.message());
    }
    /// Replaces sections.json.
    void publishList(const MadeDeck& deck, const std::vector<fs::path>& names) const {
        write({kList, [&] { return bytesOf(sectionsJson(deck, names)); }});
        publish(kList);
    }

private:
    fs::path folder_, path_;
};

fs::path withoutSlash(const fs::path& folder) {
    return folder.has_filename() ? folder : folder.parent_path();
}

/// Checks the folder, or the existing one in which it will be created.
void checkWritable(const fs::path& folder) {
    std::error_code ignored;
    fs::path there = fs::absolute(folder, ignored);
    while (there.has_relative_path() && !fs::exists(there, ignored)) there = there.parent_path();
    const bool isFolder = fs::is_directory(there, ignored);
    if (isFolder && access(there.c_str(), W_OK | X_OK) == 0) return;
    throw render::Error("cannot write into '" + printable(there.string()) +
                        "': " + (isFolder ? render::describeError(errno) : "it is not a folder"));
}

/// The names of both lists, `names` first.
std::vector<fs::path> unionOf(std::vector<fs::path> names, const std::vector<fs::path>& others) {
    Names known = setOf(names);
    for (const fs::path& name : others)
        if (known.insert(name).second) names.push_back(name);
    return names;
}

}  // namespace

void checkSlidesFolder(const fs::path& target, bool overwrite) {
    const fs::path folder = withoutSlash(target);
    std::error_code ignored;
    const bool there = fs::exists(fs::symlink_status(folder, ignored));
    if (!there || fs::is_directory(folder, ignored)) checkWritable(folder);
    if (!there) return;
    if (!fs::is_directory(folder, ignored))
        throw render::Error("cannot write '" + printable(folder.string()) +
                            "': it is not a folder");
    checkEmpty(folder, overwrite);
    checkStrangers(folder, namesOf(wordFiles(MadeDeck{})), listedFiles(folder));
}

/// If it is killed at any time, sections.json lists all files that slides runs have written there.
std::vector<fs::path> writeSlidesFolder(const MadeDeck& deck, const fs::path& target,
                                        bool overwrite) {
    const fs::path folder = withoutSlash(target);
    const Claim claim(folder);
    checkEmpty(folder, overwrite);  // again: another run may have been here since
    const std::vector<FolderFile> files = filesOf(deck);
    const std::vector<fs::path> names = namesOf(files), own = listedFiles(folder);
    checkStrangers(folder, names, own);
    const Draft draft(folder);
    for (const FolderFile& file : files) draft.write(file);
    const std::vector<fs::path> listed = unionOf(names, own);
    draft.publishList(deck, listed);
    render::makeFolder(folder / "media");
    for (const FolderFile& file : files) draft.publish(file.name);
    const Names kept = setOf(names);
    for (const fs::path& name : own) {
        std::error_code ignored;
        if (!kept.contains(name)) fs::remove(folder / name, ignored);
    }
    if (listed != names) draft.publishList(deck, names);  // else it is this list already
    return names;
}

}  // namespace demos
