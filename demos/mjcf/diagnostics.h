/// The messages about a model: its errors, and notes on what is left out.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/text/complaints.h"

namespace demos::mjcf {

/// A place in one of a model's files.
struct Spot {
    int file = 0;
    Place place{1, 1};
};

class Diagnostics {
public:
    /// Gives the file's number. The first file is the model's own.
    int addFile(const std::string& name);

    /// An error; `what`: what is wrong, its value, what would be right. Throws SceneError with all
    /// of them once they are kEnoughComplaints.
    void wrong(const Spot& spot, const std::string& what);
    /// The model can still be used. The same text for several places is reported once, with the
    /// first place.
    void note(const Spot& spot, const std::string& what);
    /// An element for MuJoCo's viewer or sensors: one note lists all of them.
    void unseen(const Spot& spot, const std::string& element);

    int errors() const { return complaints_.count(); }
    /// `file:line:column: what`, file after file.
    std::vector<std::string> errorLines() const { return complaints_.lines(); }
    std::vector<std::string> noteLines() const;

private:
    struct Note {
        Spot spot;
        std::string what;
        int places = 1;
    };
    std::string lineOf(const Spot& spot, const std::string& what) const;

    std::vector<std::string> names_;
    Complaints complaints_;
    std::vector<Note> notes_;
    std::map<std::string, std::size_t> noted_;  // indices in notes_ by text
    std::vector<std::string> unseen_;
    Spot firstUnseen_;
};

}  // namespace demos::mjcf
