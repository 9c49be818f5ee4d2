/// The text below a figure: a sentence, then how it was made. No dates: the same figure has the
/// same caption.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "demos/figure/picture_facts.h"
#include "demos/look/paper.h"

namespace demos {

class Caption {
public:
    /// `sentence`: without its full stop.
    explicit Caption(std::string sentence) : sentence_(std::move(sentence)) {}
    /// Adds nothing if the value is empty.
    void add(const std::string& name, const std::string& value);
    /// The sentence, an empty line, then "name: value" lines.
    std::string text() const;

private:
    std::string sentence_;
    std::vector<std::pair<std::string, std::string>> rows_;
};

/// "Stack: ten boxes stay where they are put", else the scene's name.
std::string titleOf(const SceneDescription& scene);

/// Names of the files, size on paper and in pixels.
void addFiles(const std::vector<std::string>& files, PictureSize size, const Paper& paper,
              Caption& caption);
/// Theme, colours, and the overlays shown in at least one picture.
void addLook(const Overlays& overlays, const std::vector<PictureFacts>& facts, Caption& caption);
/// The scene's name, its steps, and what differs from the default world.
void addWorld(const SceneDescription& scene, const Options& options, Caption& caption);
/// addWorld(), the solver, and what was set.
void addPhysics(const SceneDescription& scene, const Options& options, Caption& caption);
/// "steady; substeps=8": the preset, and what differs from it.
std::string solverText(const SceneDescription& scene);
/// Times, steps and state hashes.
void addShots(const std::vector<PictureFacts>& facts, Caption& caption);
/// Program and command: the last lines.
void addProgram(const Options& options, Caption& caption);

}  // namespace demos
