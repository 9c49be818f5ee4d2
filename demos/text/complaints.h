/// Collects everything that is wrong with a scene, so that one run reports all of it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "demos/text/place.h"

namespace demos {

/// Text that is safe for a terminal: control bytes and invalid UTF-8 are written as \x1b.
std::string printable(std::string_view text);

/// The user's text in a message: its first `most` bytes, followed by "..." if there are more.
std::string shown(std::string_view text, std::size_t most = 64);

/// A message with texts that nobody has cut.
inline constexpr std::size_t kLongestMessage = 2000;  // bytes

/// The shortest text that reads back to the same number.
std::string numberText(double value);

/// Readers of long lists stop here: to find what each unknown name may have meant takes time.
inline constexpr int kEnoughComplaints = 100;

class Complaints {
public:
    /// `options`: the texts after --set. The k-th of them (from 1) has the place {0, k}.
    explicit Complaints(std::vector<std::string> options = {});

    /// The number of the file in places.
    int addFile(std::string name);
    /// Empty if the place is an option.
    std::string fileOf(Place place) const;

    /// `what`: one sentence with what is wrong, the value, and what would be right.
    void add(Place place, std::string what);
    /// Adds the complaints about a file that was read separately.
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
