/// A gallery's scenes are read and drawn in processes of their own: the result of each.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/film/progress.h"
#include "demos/gallery/gallery_scenes.h"
#include "demos/processes/process_pool.h"
#include "demos/text/stop.h"

namespace demos {

/// In the scene's process: what `work` returns, or why it failed, as text for the parent.
std::string attempted(const std::function<std::string()>& work) noexcept;

/// What `work` returned to `attempted`; nothing if it failed.
std::optional<std::string> textOf(const PoolResult& result);

/// In the parent: reports failures of scenes and keeps the code of the first one.
class GalleryTroubles {
public:
    explicit GalleryTroubles(const Talk& talk) : talk_(talk) {}
    /// Sets `text` to what `work` returned; false: it failed, which take() reports. Throws Stop
    /// (usage) if the command line is wrong.
    bool take(const GalleryChoice& choice, const PoolResult& result, std::string& text);
    /// Reports what happened in the simulation of a scene that was drawn; "": nothing.
    void tellIncident(const std::string& name, const std::string& line);
    int count() const { return count_; }
    /// Of the first failure; diverged if there were only incidents; else ok.
    Exit code() const { return code_; }

private:
    void tell(const std::string& name, const std::vector<std::string>& lines, Exit code);

    const Talk& talk_;
    int count_ = 0;
    Exit code_ = Exit::ok;
};

}  // namespace demos
