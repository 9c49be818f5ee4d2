#include "demos/mjcf/diagnostics.h"

#include <algorithm>
#include <tuple>

#include "demos/scene/reader.h"

namespace demos::mjcf {
namespace {

auto orderOf(const Spot& spot) { return std::tuple(spot.file, spot.place.line, spot.place.column); }

}  // namespace

int Diagnostics::addFile(const std::string& name) {
    names_.push_back(name);
    return complaints_.addFile(name);
}

void Diagnostics::wrong(const Spot& spot, const std::string& what) {
    Place place = spot.place;
    place.file = spot.file;
    complaints_.add(place, what);
    if (complaints_.count() >= kEnoughComplaints) throw SceneError(errorLines());
}

void Diagnostics::note(const Spot& spot, const std::string& what) {
    const auto [found, isNew] = noted_.emplace(what, notes_.size());
    if (isNew) {
        notes_.push_back({spot, what});
        return;
    }
    Note& note = notes_[found->second];
    ++note.places;
    if (orderOf(spot) < orderOf(note.spot)) note.spot = spot;
}

void Diagnostics::unseen(const Spot& spot, const std::string& element) {
    if (unseen_.empty() || orderOf(spot) < orderOf(firstUnseen_)) firstUnseen_ = spot;
    const std::string name = "<" + element + ">";
    if (std::find(unseen_.begin(), unseen_.end(), name) == unseen_.end()) unseen_.push_back(name);
}

std::string Diagnostics::lineOf(const Spot& spot, const std::string& what) const {
    return printable(names_[static_cast<std::size_t>(spot.file)] + ":" +
                     std::to_string(spot.place.line) + ":" + std::to_string(spot.place.column) +
                     ": " + shown(what, kLongestMessage));
}

std::vector<std::string> Diagnostics::noteLines() const {
    std::vector<Note> sorted = notes_;
    if (!unseen_.empty()) {
        std::string list;
        for (const std::string& name : unseen_) list += (list.empty() ? "" : ", ") + name;
        sorted.push_back({firstUnseen_, list + ": for MuJoCo's viewer and sensors; left out"});
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const Note& a, const Note& b) {
        return orderOf(a.spot) < orderOf(b.spot);
    });
    std::vector<std::string> lines;
    for (const Note& note : sorted) {
        const std::string more =
            note.places > 1 ? " (" + std::to_string(note.places) + " places)" : "";
        lines.push_back(lineOf(note.spot, note.what + more));
    }
    return lines;
}

}  // namespace demos::mjcf
