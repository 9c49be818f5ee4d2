/// Scenes of a gallery are read and drawn in processes of their own: what becomes of each.
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

/// In the scene's process: what `work` returns, or why it did not, as a text for the parent.
std::string attempted(const std::function<std::string()>& work) noexcept;

/// What `attempted` was given, without its mark; nothing where that has failed.
std::optional<std::string> textOf(const PoolResult& result);

/// In the parent: tells what went wrong with scenes, and remembers how the first one failed.
class GalleryTroubles {
public:
    explicit GalleryTroubles(const Talk& talk) : talk_(talk) {}
    /// What `attempted` was given, without its mark; false: it has failed, and that is reported.
    /// Throws Stop (usage) where the command line is what is wrong.
    bool take(const GalleryChoice& choice, const PoolResult& result, std::string& text);
    int count() const { return count_; }
    /// Of the first that failed; ok where none has.
    Exit code() const { return code_; }

private:
    void tell(const std::string& name, const std::vector<std::string>& lines, Exit code);

    const Talk& talk_;
    int count_ = 0;
    Exit code_ = Exit::ok;
};

}  // namespace demos
