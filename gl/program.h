#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/space/camera.h"
#include "core/space/layout.h"
#include "gl/objects.h"
#include "gl/render_options.h"

namespace vvr::gl {

/// A piece of a shader.
struct ShaderChunk {
    std::string_view file;  ///< in glsl/
    std::string_view text;
};

/// The piece that is a file in glsl/. \throws std::logic_error when there is none of that name
ShaderChunk shader_chunk(std::string_view file);

/// A vertex and a fragment shader, each made of pieces that follow one another.
struct ProgramSource {
    std::string name;  ///< for messages: "the arrows"
    std::vector<ShaderChunk> vertex;
    std::vector<ShaderChunk> fragment;
};

/// The text of a shader: "#version 330 core", then each piece behind a #line with its number k, from 1 on. The lines of
/// piece k are numbered from 1000 k + 1 on, as Mesa's messages name only the line.
std::string shader_text(std::span<const ShaderChunk> pieces);

/// A linked program.
class Program {
  public:
    /// \throws Error backend with the compiler's or linker's log and the numbers of each file's lines
    Program(const GladGLContext& gl, const ProgramSource& source);

    void use() const { gl_->UseProgram(program_.id()); }

    // These set a uniform of the program in use. They throw std::logic_error when no piece declares the uniform. A
    // uniform that the compiler has optimised away is ignored.
    void set(const char* uniform, int value) const { gl_->Uniform1i(at(uniform), value); }
    void set(const char* uniform, float value) const { gl_->Uniform1f(at(uniform), value); }
    void set(const char* uniform, const glm::vec2& value) const { gl_->Uniform2f(at(uniform), value.x, value.y); }
    void set(const char* uniform, const glm::vec3& value) const {
        gl_->Uniform3f(at(uniform), value.x, value.y, value.z);
    }
    void set(const char* uniform, const glm::vec4& value) const {
        gl_->Uniform4f(at(uniform), value.x, value.y, value.z, value.w);
    }
    void set(const char* uniform, const glm::mat4& value) const {
        gl_->UniformMatrix4fv(at(uniform), 1, GL_FALSE, &value[0][0]);
    }

  private:
    GLint at(std::string_view uniform) const;

    const GladGLContext* gl_;
    std::string name_;
    GlProgram program_;
    std::map<std::string, GLint, std::less<>> uniforms_;  ///< locations of those that the pieces declare
};

}  // namespace vvr::gl

// Every program that the renderer uses: which files in glsl/ its shaders are made of.
namespace vvr::gl {

/// What a program draws: a picture's colours, or the data of each pixel (gl/framebuffer.h).
enum class Channels { colour, pixel_data };

ProgramSource arrow_program(Channels channels);
ProgramSource traceline_program(Channels channels);
ProgramSource frame_program(Channels channels);
ProgramSource line_program();
ProgramSource floor_program();

/// Joins the samples of each pixel.
ProgramSource resolve_program();

ProgramSource volume_program(const space::Layout& layout, VolumeColour colour, VolumeShading shading,
                             Channels channels);

/// Sets the uniforms that the layout's shader declares, in the program in use.
void set_layout(const Program& program, const space::Layout& layout);

/// The direction to the light that all is drawn in: above and behind the viewer's left shoulder.
inline glm::vec3 to_light(const space::Camera& camera) {
    const glm::dvec3 right = glm::cross(glm::dvec3(0, 1, 0), camera.forward);
    return glm::vec3(glm::normalize(glm::dvec3(0, 1.4, 0) - camera.forward - 0.4 * right));
}

}  // namespace vvr::gl
