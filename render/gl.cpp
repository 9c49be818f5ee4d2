#include "render/gl.h"

#include <array>
#include <string>

#include "render/error.h"

namespace render {
namespace {

std::string compileLog(GLuint shader) {
    std::array<char, 1024> text{};
    glGetShaderInfoLog(shader, text.size(), nullptr, text.data());
    return text.data();
}

Object compile(GLenum kind, std::string_view name, std::string_view prefix) {
    const std::string text = "#version 330 core\n#extension GL_ARB_texture_gather : require\n" +
                             std::string(prefix) + std::string(shaderText("common.glsl")) +
                             std::string(shaderText(name));
    Object shader{glCreateShader(kind), [](GLuint id) { glDeleteShader(id); }};
    const char* source = text.c_str();
    glShaderSource(shader.id(), 1, &source, nullptr);
    glCompileShader(shader.id());
    GLint good = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
    if (good != GL_TRUE)
        throw Error("renderer: shader " + std::string(name) + ": " + compileLog(shader.id()));
    return shader;
}

const char* errorName(GLenum code) {
    switch (code) {
        case GL_INVALID_ENUM: return "invalid enum";
        case GL_INVALID_VALUE: return "invalid value";
        case GL_INVALID_OPERATION: return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION: return "invalid framebuffer operation";
        case GL_OUT_OF_MEMORY: return "out of memory";
        default: return "unknown error";
    }
}

}  // namespace

Object makeBuffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return {id, [](GLuint name) { glDeleteBuffers(1, &name); }};
}

Object makeVertexArray() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return {id, [](GLuint name) { glDeleteVertexArrays(1, &name); }};
}

Object makeFramebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return {id, [](GLuint name) { glDeleteFramebuffers(1, &name); }};
}

Object makeTexture(int width, int height, GLenum internalFormat) {
    GLuint id = 0;
    glGenTextures(1, &id);
    Object texture{id, [](GLuint name) { glDeleteTextures(1, &name); }};
    glBindTexture(GL_TEXTURE_2D, id);
    const bool isDepth = internalFormat == GL_DEPTH_COMPONENT32F;
    const bool isFloat = internalFormat == GL_RG16F;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0,
                 isDepth ? GL_DEPTH_COMPONENT : GL_RGBA,
                 isDepth || isFloat ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

Object makeRenderbuffer(int width, int height, int samples, GLenum internalFormat) {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    Object buffer{id, [](GLuint name) { glDeleteRenderbuffers(1, &name); }};
    glBindRenderbuffer(GL_RENDERBUFFER, id);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, internalFormat,
                                     width, height);
    return buffer;
}

void requireComplete(const char* name) {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error("renderer: framebuffer '" + std::string(name) + "' is not complete (" +
                    std::to_string(status) + "); out of memory?");
}

Program::Program(std::string_view vertexName, std::string_view fragmentName,
                 std::string_view prefix)
    : object_{glCreateProgram(), [](GLuint id) { glDeleteProgram(id); }} {
    const Object vertex = compile(GL_VERTEX_SHADER, vertexName, prefix);
    const Object fragment = compile(GL_FRAGMENT_SHADER, fragmentName, prefix);
    glAttachShader(object_.id(), vertex.id());
    glAttachShader(object_.id(), fragment.id());
    glLinkProgram(object_.id());
    GLint good = GL_FALSE;
    glGetProgramiv(object_.id(), GL_LINK_STATUS, &good);
    if (good != GL_TRUE)
        throw Error("renderer: shaders " + std::string(vertexName) + " and " +
                    std::string(fragmentName) + " do not link");
    const GLuint block = glGetUniformBlockIndex(object_.id(), "FrameBlock");
    if (block != GL_INVALID_INDEX)
        glUniformBlockBinding(object_.id(), block, kFrameBlockBinding);
}

void Program::setSampler(const char* name, int unit) const {
    use();
    glUniform1i(uniform(name), unit);
}

void drawFullScreen(const Object& emptyVertexArray) {
    glBindVertexArray(emptyVertexArray.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void checkGl(const char* where) {
    const GLenum code = glGetError();
    if (code != GL_NO_ERROR)
        throw Error("renderer: OpenGL reports '" + std::string(errorName(code)) + "' in " + where);
}

}  // namespace render
