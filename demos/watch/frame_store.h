/// The pictures of a film, by their number, in a file without a name: it takes no memory, however
/// long the film is, and leaves nothing behind.
#pragma once
#include <filesystem>
#include <memory>

#include "render/encode/descriptor.h"
#include "render/image.h"

namespace demos {

class FrameStore {
public:
    /// On the file system of `beside`, for pictures of this size in pixels. Throws render::Error.
    FrameStore(const std::filesystem::path& beside, int width, int height);
    /// Throws render::Error when the disk is full.
    void put(int frame, const render::Image& image);
    /// A picture that was put there.
    render::Image get(int frame) const;
    int width() const { return width_; }
    int height() const { return height_; }

private:
    std::size_t bytes() const { return 4 * static_cast<std::size_t>(width_) * height_; }

    render::Descriptor file_;
    int width_, height_;
};

}  // namespace demos
