/// A scene's [[section]] as a slide.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/slides/deck.h"
#include "demos/text/complaints.h"

namespace demos {

/// Texts of the scene files whose sections are told of, each read once.
class SectionFiles {
public:
    explicit SectionFiles(Complaints& complaints) : complaints_(complaints) {}

    /// The number of the file in complaints, and its text: empty where it cannot be read any more.
    struct File {
        int number = 0;
        std::string text;
    };
    const File& of(const std::string& name);

private:
    Complaints& complaints_;
    std::map<std::string, File> files_;
};

/// What the section gives a slide: its words, its part of the run, how that plays. `several`: the
/// slide compares runs, for which the section has no charts.
void takeSection(const SceneDescription& scene, const Section& section, bool several, Slide& slide);

/// Complains of the section's words, at their places in the scene's file; at `otherwise` where they
/// have none, as after --set.
void checkSection(const Section& section, const std::vector<SceneDescription>& runs,
                  Place otherwise, SectionFiles& files, Complaints& complaints);

}  // namespace demos
