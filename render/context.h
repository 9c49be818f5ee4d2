/// An OpenGL 3.3 core context without a window. Behind an interface because Mesa 25.1 dropped
/// OSMesa: an EGL surfaceless context takes its place there by one more file like
/// context_osmesa.cpp.
#pragma once
#include <memory>
#include <string>

#include "render/image.h"

namespace render {

class Context {
   public:
    virtual ~Context() = default;

    /// Makes it this thread's context; false if the driver refuses.
    virtual bool makeCurrent() = 0;

    /// "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6"
    virtual std::string describe() const = 0;

    int width() const { return width_; }
    int height() const { return height_; }

    /// The framebuffer bound for reading, top row first.
    Image read() const;

   protected:
    Context(int width, int height) : width_(width), height_(height) {}

   private:
    int width_, height_;  // pixels
};

/// Makes the context, makes it current and loads GL's functions; throws Error.
std::unique_ptr<Context> makeContext(int width, int height);

}  // namespace render
