#include "gl/program.h"

#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

void compile(const GladGLContext& gl, GLuint shader, std::string_view name,
             std::initializer_list<std::string_view> pieces) {
    std::vector<const char*> texts = {"#version 330 core\n"};
    std::vector<GLint> lengths = {-1};
    for (const std::string_view piece : pieces) {
        texts.push_back(piece.data());
        lengths.push_back(static_cast<GLint>(piece.size()));
    }
    gl.ShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    gl.CompileShader(shader);
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw Error(ErrorKind::backend, fmt::format("the driver does not compile {}: {}", name, log));
}

}  // namespace

Program::Program(const GladGLContext& gl, std::string name, std::initializer_list<std::string_view> vertex,
                 std::initializer_list<std::string_view> fragment)
    : gl_(&gl), program_(gl) {
    const GlVertexShader vertex_shader(gl);
    const GlFragmentShader fragment_shader(gl);
    compile(gl, vertex_shader.id(), name + "'s vertex shader", vertex);
    compile(gl, fragment_shader.id(), name + "'s fragment shader", fragment);
    gl.AttachShader(program_.id(), vertex_shader.id());
    gl.AttachShader(program_.id(), fragment_shader.id());
    gl.LinkProgram(program_.id());
    GLint done = GL_FALSE;
    gl.GetProgramiv(program_.id(), GL_LINK_STATUS, &done);
    if (done == GL_TRUE) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetProgramInfoLog(program_.id(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw Error(ErrorKind::backend, fmt::format("the driver does not link {}: {}", name, log));
}

}  // namespace vvr
