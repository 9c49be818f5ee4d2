/// OpenGL objects that free themselves.
#pragma once
#include <glad/gl.h>

#include <string>
#include <utility>
#include <vector>

#include "render/frame.h"

namespace render {

/// The name of one OpenGL object, which is deleted with its owner.
template <auto Delete>
class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    ~GlName() {
        if (name_ != 0) Delete(name_);
    }
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

inline void deleteBuffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void deleteArray(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void deleteTexture(GLuint name) { glDeleteTextures(1, &name); }
inline void deleteFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void deleteRenderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline void deleteProgram(GLuint name) { glDeleteProgram(name); }

using GlBuffer = GlName<deleteBuffer>;
using GlArray = GlName<deleteArray>;
using GlTexture = GlName<deleteTexture>;
using GlFramebuffer = GlName<deleteFramebuffer>;
using GlRenderbuffer = GlName<deleteRenderbuffer>;
using GlProgram = GlName<deleteProgram>;

GlBuffer newBuffer();
GlArray newArray();
/// NEAREST, clamped; `format` is a sized format (GL_RGBA8, GL_R8, GL_DEPTH_COMPONENT16 ...).
GlTexture newTexture(GLenum format, int width, int height);
GlRenderbuffer newRenderbuffer(GLenum format, int width, int height);
/// A framebuffer with these attachments (0 = none). `secondBuffer`: for a second colour. Throws
/// Error if it is incomplete.
GlFramebuffer newFramebuffer(GLuint colorTexture, GLuint depthTexture, GLuint colorBuffer = 0,
                             GLuint depthBuffer = 0, GLuint secondBuffer = 0);

/// Compiles and links two files of render/shaders, given without their extensions .vert and .frag.
/// `defines`: macros defined in both, separated by blanks.
/// Throws Error with the compiler's first line.
GlProgram newProgram(const std::string& vertex, const std::string& fragment,
                     const std::string& defines = "");

void setUniform(GLuint program, const char* name, int value);
void setUniform(GLuint program, const char* name, float value);
void setUniform(GLuint program, const char* name, float x, float y);
void setUniform(GLuint program, const char* name, const Vec3& value);
void setUniform(GLuint program, const char* name, const Eigen::Matrix4f& value);
void setColorUniform(GLuint program, const char* name, const Color& color);

/// Draws a triangle that covers the picture; its three corners need no buffer.
void drawFullScreen(GLuint emptyArray);

}  // namespace render
