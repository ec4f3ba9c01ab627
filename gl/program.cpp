#include "gl/program.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "core/base/error.h"
#include "gl/context.h"
#include "shaders.h"

namespace vvr::gl {

namespace {

/// Throws if compiling or linking failed.
template <class Get, class GetLog>
void check_done(GLuint id, GLenum what, Get get, GetLog get_log, const std::string& failed) {
    GLint done = GL_FALSE;
    get(id, what, &done);
    if (done == GL_TRUE) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    get_log(id, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw_if_out_of_memory(fmt::format("{}: {}", failed, log));
    throw Error(ErrorCode::backend, fmt::format("{}: {}", failed, log));
}

void compile(const GladGLContext& gl, GLuint shader, const std::string& name, std::span<const ShaderChunk> chunks) {
    const std::string text = shader_text(chunks);
    const char* const begin = text.c_str();
    gl.ShaderSource(shader, 1, &begin, nullptr);
    gl.CompileShader(shader);
    std::string files;
    for (std::size_t i = 0; i < chunks.size(); ++i) files += fmt::format(" {}001... {}", i + 1, chunks[i].file);
    check_done(shader, GL_COMPILE_STATUS, gl.GetShaderiv, gl.GetShaderInfoLog,
               fmt::format("the driver cannot compile {} (lines{})", name, files));
}

}  // namespace

ShaderChunk shader_chunk(std::string_view file) {
    const auto found = std::ranges::find(shaders::files, file, [](const auto& entry) { return entry.first; });
    if (found == shaders::files.end()) throw std::logic_error(fmt::format("there is no shader file '{}'", file));
    return {found->first, found->second};
}

std::string shader_text(std::span<const ShaderChunk> chunks) {
    // For glsl/pixel_data_over.glsl; a driver without it ignores the line.
    std::string text = "#version 330 core\n#extension GL_EXT_shader_framebuffer_fetch : enable\n";
    for (std::size_t i = 0; i < chunks.size(); ++i)
        text += fmt::format("#line {}001 {}\n{}\n", i + 1, i + 1, chunks[i].text);
    return text;
}

Program::Program(const GladGLContext& gl, const ProgramSource& source) : gl_(&gl), name_(source.name), program_(gl) {
    const GlVertexShader vertex_shader(gl);
    const GlFragmentShader fragment_shader(gl);
    compile(gl, vertex_shader.id(), name_ + "'s vertex shader", source.vertex);
    compile(gl, fragment_shader.id(), name_ + "'s fragment shader", source.fragment);
    gl.AttachShader(program_.id(), vertex_shader.id());
    gl.AttachShader(program_.id(), fragment_shader.id());
    gl.LinkProgram(program_.id());
    check_done(program_.id(), GL_LINK_STATUS, gl.GetProgramiv, gl.GetProgramInfoLog,
               fmt::format("the driver cannot link {}", name_));
    for (const auto* chunks : {&source.vertex, &source.fragment}) {
        std::istringstream words(shader_text(*chunks));
        for (std::string word, type, name; words >> word;) {
            if (word != "uniform" || !(words >> type >> name)) continue;
            name = name.substr(0, name.find(';'));
            uniforms_[name] = gl.GetUniformLocation(program_.id(), name.c_str());
        }
    }
}

GLint Program::at(std::string_view uniform) const {
    const auto found = uniforms_.find(uniform);
    if (found == uniforms_.end()) throw std::logic_error(fmt::format("{} has no uniform '{}'", name_, uniform));
    return found->second;
}

namespace {

ProgramSource source(std::string name, const std::vector<std::string_view>& vertex,
                     const std::vector<std::string_view>& fragment) {
    ProgramSource source{std::move(name), {}, {}};
    std::ranges::transform(vertex, std::back_inserter(source.vertex), shader_chunk);
    std::ranges::transform(fragment, std::back_inserter(source.fragment), shader_chunk);
    return source;
}

}  // namespace

ProgramSource arrow_program(Channels channels) {
    if (channels == Channels::pixel_data) return source("the arrows' pixel data", {"arrow.vert"}, {"pixel_data.frag"});
    return source("the arrows", {"arrow.vert"}, {"arrow.frag"});
}

ProgramSource traceline_program(Channels channels) {
    if (channels == Channels::pixel_data) {
        return source("the tracelines' pixel data", {"trace.vert"}, {"pixel_data.frag"});
    }
    return source("the tracelines", {"trace.vert"}, {"trace.frag"});
}

ProgramSource frame_program(Channels channels) {
    if (channels == Channels::pixel_data) {
        return source("the standing frames' pixel data", {"picture.vert"},
                      {"pixel_data_over.glsl", "pixel_data_picture.frag"});
    }
    return source("the standing frames", {"picture.vert"}, {"picture.frag"});
}

ProgramSource line_program() {
    return source("the lines", {"line.vert"}, {"line.frag"});
}

ProgramSource floor_program() {
    return source("the floor", {"picture.vert"}, {"floor.frag"});
}

ProgramSource resolve_program() {
    return source("the multisample resolve", {"resolve.vert"}, {"resolve.frag"});
}

ProgramSource volume_program(const space::Layout& layout, VolumeColour colour, VolumeShading shading,
                             Channels channels) {
    const std::string_view map = layout.shader();
    std::vector<std::string_view> fragment{"volume_in.glsl", map, "volume_sample.glsl"};
    if (colour == VolumeColour::object) fragment.emplace_back("voxel_identity.glsl");
    fragment.push_back(row_of(colour).shader);
    if (channels == Channels::pixel_data) {
        fragment.insert(fragment.end(), {"pixel_data_over.glsl", "pixel_data_volume.frag"});
        return source("the volume's pixel data", {map, "volume.vert"}, fragment);
    }
    fragment.push_back(std::ranges::find(volume_shadings, shading, &VolumeShadingRow::shading)->shader);
    fragment.emplace_back("volume.frag");
    return source("the volume", {map, "volume.vert"}, fragment);
}

void set_layout(const Program& program, const space::Layout& layout) {
    for (const space::LayoutUniform& uniform : layout.uniforms())
        program.set(uniform.name, static_cast<float>(uniform.value));
}

}  // namespace vvr::gl
