/// A scene's [[section]] as a slide.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/slides/deck.h"
#include "demos/text/complaints.h"

namespace demos {

/// Texts of the scene files whose sections have complaints, each read once.
class SectionFiles {
public:
    explicit SectionFiles(Complaints& complaints) : complaints_(complaints) {}

    /// The number of the file in complaints, and its text; empty if it can no longer be read.
    struct File {
        int number = 0;
        std::string text;
    };
    const File& of(const std::string& name);

private:
    Complaints& complaints_;
    std::map<std::string, File> files_;
};

/// Copies the section's words, part of the run and playback settings to the slide. `several`: the
/// slide compares runs, for which the section has no charts.
void copySection(const SceneDescription& scene, const Section& section, bool several, Slide& slide);

/// Complains about the section's words, at their places in the scene's file; at `otherwise` if they
/// have no place, as after --set.
void checkSection(const Section& section, const std::vector<SceneDescription>& runs,
                  Place otherwise, SectionFiles& files, Complaints& complaints);

}  // namespace demos
