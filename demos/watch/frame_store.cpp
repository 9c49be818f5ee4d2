#include "demos/watch/frame_store.h"

#include <unistd.h>

#include <cerrno>

#include "render/encode/file.h"
#include "render/error.h"

namespace demos {

FrameStore::FrameStore(const std::filesystem::path& beside, int width, int height)
    : file_(render::createUnnamed(beside), "keep a draft's frames"),
      width_(width),
      height_(height) {}

void FrameStore::put(int frame, const render::Image& image) {
    for (std::size_t at = 0; at < bytes();) {
        const ssize_t wrote = pwrite(file_.number(), image.pixels.data() + at, bytes() - at,
                                     static_cast<off_t>(bytes()) * frame + static_cast<off_t>(at));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0)
            throw render::Error("cannot keep a draft's frame: " + render::describeError(errno));
        at += static_cast<std::size_t>(wrote);
    }
}

render::Image FrameStore::get(int frame) const {
    render::Image image{width_, height_, {}};
    image.pixels.resize(bytes());
    for (std::size_t at = 0; at < bytes();) {
        const ssize_t got = pread(file_.number(), image.pixels.data() + at, bytes() - at,
                                  static_cast<off_t>(bytes()) * frame + static_cast<off_t>(at));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0)
            throw render::Error("cannot read a draft's frame: " + render::describeError(errno));
        at += static_cast<std::size_t>(got);
    }
    return image;
}

}  // namespace demos
