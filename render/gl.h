/// OpenGL 3.3 through glad, and the few GL objects the passes use: each owns its name, moves and
/// never copies. All of it needs a current context, the destructors too.
#pragma once
#include <glad/gl.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace render {

/// A GL name and how to delete it.
class Object {
   public:
    using Delete = void (*)(GLuint);
    Object() = default;
    Object(GLuint id, Delete destroy) : id_(id), destroy_(destroy) {}
    Object(Object&& other) noexcept
        : id_(std::exchange(other.id_, 0)), destroy_(std::exchange(other.destroy_, nullptr)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(destroy_, other.destroy_);
        return *this;
    }
    ~Object() {
        if (destroy_ != nullptr) destroy_(id_);
    }
    GLuint id() const { return id_; }

   private:
    GLuint id_ = 0;
    Delete destroy_ = nullptr;
};

Object makeBuffer();
Object makeVertexArray();
Object makeFramebuffer();

/// NEAREST, clamped, no mip-maps: GL's linear filter gives other bits on other CPUs.
Object makeTexture(int width, int height, GLenum internalFormat);

/// A renderbuffer of `samples` per pixel (1 = plain).
Object makeRenderbuffer(int width, int height, int samples, GLenum internalFormat);

/// Attaches to the framebuffer that is bound; throws Error when it is not complete.
void requireComplete(const char* name);

/// A vertex and a fragment shader of render/shaders; `prefix` goes in front of both ("#define BOX").
class Program {
   public:
    Program(std::string_view vertexName, std::string_view fragmentName, std::string_view prefix = {});
    void use() const { glUseProgram(object_.id()); }
    GLint uniform(const char* name) const { return glGetUniformLocation(object_.id(), name); }
    /// Binds the sampler `name` to texture unit `unit`, once.
    void setSampler(const char* name, int unit) const;

   private:
    Object object_;
};

/// Every program sees the uniform block FrameBlock here.
inline constexpr GLuint kFrameBlockBinding = 0;

/// A vertex array without attributes: three vertices that cover the picture.
void drawFullScreen(const Object& emptyVertexArray);

/// Throws Error naming `where` when GL has reported a failure.
void checkGl(const char* where);

/// The text of a file of render/shaders, built in.
std::string_view shaderText(std::string_view name);

}  // namespace render
