#include "render/gl.h"

#include <sstream>

#include "render/context_kinds.h"
#include "render/error.h"
#include "render/linear.h"
#include "render/shaders.h"

namespace render {

std::string describeOpenGl() {
    const auto text = [](GLenum name) {
        const GLubyte* words = glGetString(name);
        return std::string(words ? reinterpret_cast<const char*>(words) : "unknown");
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

GlBuffer newBuffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return GlBuffer(name);
}

GlArray newArray() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return GlArray(name);
}

GlTexture newTexture(GLenum format, int width, int height) {
    const bool color = format == GL_RGBA8 || format == GL_R8;
    const GLenum layout = !color ? GL_DEPTH_COMPONENT : format == GL_RGBA8 ? GL_RGBA : GL_RED;
    const GLenum type = color ? GL_UNSIGNED_BYTE : GL_FLOAT;
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, layout, type,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return GlTexture(name);
}

GlRenderbuffer newRenderbuffer(GLenum format, int width, int height) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    return GlRenderbuffer(name);
}

GlFramebuffer newFramebuffer(GLuint colorTexture, GLuint depthTexture, GLuint colorBuffer,
                             GLuint depthBuffer, GLuint secondBuffer) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    GlFramebuffer framebuffer(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    const auto texture = [](GLenum where, GLuint what) {
        if (what) glFramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, what, 0);
    };
    const auto buffer = [](GLenum where, GLuint what) {
        if (what) glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, what);
    };
    texture(GL_COLOR_ATTACHMENT0, colorTexture);
    texture(GL_DEPTH_ATTACHMENT, depthTexture);
    buffer(GL_COLOR_ATTACHMENT0, colorBuffer);
    buffer(GL_COLOR_ATTACHMENT1, secondBuffer);
    buffer(GL_DEPTH_ATTACHMENT, depthBuffer);
    if (!colorTexture && !colorBuffer) {
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error("OpenGL rejects a framebuffer (status " + std::to_string(status) +
                    "); is the picture too large for memory?");
    return framebuffer;
}

namespace {

/// Inserts the definitions after the first line of the source, `#version`.
GLuint compile(GLenum stage, const std::string& name, const std::string& defines) {
    std::string text = shaderText(name);
    text.insert(text.find('\n') + 1, defines);
    const GLuint shader = glCreateShader(stage);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    char log[512] = {};
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    const std::string all(log);
    throw Error("shader " + name + ": " + all.substr(0, all.find('\n')));
}

}  // namespace

GlProgram newProgram(const std::string& vertex, const std::string& fragment,
                     const std::string& defines) {
    std::istringstream words(defines);
    std::string lines;
    for (std::string word; words >> word;) lines += "#define " + word + "\n";
    GlProgram program(glCreateProgram());
    const std::pair<GLenum, std::string> stages[] = {{GL_VERTEX_SHADER, vertex + ".vert"},
                                                     {GL_FRAGMENT_SHADER, fragment + ".frag"}};
    for (const auto& [stage, file] : stages) {
        const GLuint shader = compile(stage, file, lines);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) throw Error("shaders " + vertex + " and " + fragment + " do not link");
    return program;
}

void setUniform(GLuint program, const char* name, int value) {
    glUniform1i(glGetUniformLocation(program, name), value);
}
void setUniform(GLuint program, const char* name, float value) {
    glUniform1f(glGetUniformLocation(program, name), value);
}
void setUniform(GLuint program, const char* name, float x, float y) {
    glUniform2f(glGetUniformLocation(program, name), x, y);
}
void setUniform(GLuint program, const char* name, const Vec3& value) {
    glUniform3fv(glGetUniformLocation(program, name), 1, value.data());
}
void setUniform(GLuint program, const char* name, const Eigen::Matrix4f& value) {
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, value.data());
}

void setColorUniform(GLuint program, const char* name, const Color& color) {
    setUniform(program, name, linear(color));
}

void drawFullScreen(GLuint emptyArray) {
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace render
