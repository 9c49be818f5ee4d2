/// All that is wrong with a scene, collected, so that one run tells everything.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "demos/text/place.h"

namespace demos {

/// Text that a terminal can be given: control bytes and what is not UTF-8 as \x1b.
std::string printable(std::string_view text);

/// What was written, for a message: its first 64 bytes, and "..." where there are more.
std::string shown(std::string_view text);

/// The shortest text that reads back to the same number.
std::string numberText(double value);

class Complaints {
public:
    /// `options`: the texts after --set. What the k-th of them (from 1) says is at Place{0, k}.
    explicit Complaints(std::vector<std::string> options = {});

    /// The number of the file in places.
    int addFile(std::string name);
    /// Empty where the place is an option.
    std::string fileOf(Place place) const;

    /// `what`: one sentence: what is wrong, its value, what would be right.
    void add(Place place, std::string what);
    /// Of a file that was read on its own.
    void addAll(const Complaints& of, int file);
    int count() const { return static_cast<int>(complaints_.size()); }
    /// `file:line:column: what`, in the order of the files, options first; at most 20 and a
    /// summary of the rest.
    std::vector<std::string> lines() const;

private:
    struct Complaint {
        Place place;
        std::string what;
    };
    std::string lineOf(const Complaint& complaint) const;

    std::vector<std::string> files_, options_;
    std::vector<Complaint> complaints_;
};

}  // namespace demos
