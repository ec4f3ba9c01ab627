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

/// A part of a shader: one file in glsl/.
struct ShaderChunk {
    std::string_view file;  ///< in glsl/
    std::string_view text;
};

/// \throws std::logic_error if glsl/ has no such file
ShaderChunk shader_chunk(std::string_view file);

/// A vertex and a fragment shader, each a concatenation of chunks.
struct ProgramSource {
    std::string name;  ///< for messages: "the arrows"
    std::vector<ShaderChunk> vertex;
    std::vector<ShaderChunk> fragment;
};

/// The source of a shader: "#version 330 core", then each chunk k = 1, 2, … after a #line directive. Lines of chunk k
/// are numbered from 1000 k + 1, because Mesa's messages give only the line number.
std::string shader_text(std::span<const ShaderChunk> chunks);

/// A linked shader program.
class Program {
  public:
    /// \throws Error backend with the compiler's or linker's log and the line numbers of each file
    Program(const GladGLContext& gl, const ProgramSource& source);

    void use() const { gl_->UseProgram(program_.id()); }

    // Set a uniform of the program in use. They throw std::logic_error if no chunk declares the uniform, and ignore
    // uniforms that the compiler removed.
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
    std::map<std::string, GLint, std::less<>> uniforms_;  ///< locations by name
};

}  // namespace vvr::gl

// The renderer's programs: which files in glsl/ each is made of.
namespace vvr::gl {

/// Whether a program draws colours or pixel data (gl/framebuffer.h).
enum class Channels { colour, pixel_data };

ProgramSource arrow_program(Channels channels);
ProgramSource traceline_program(Channels channels);
ProgramSource frame_program(Channels channels);
ProgramSource line_program();
ProgramSource floor_program();

/// Averages the samples of each pixel.
ProgramSource resolve_program();

ProgramSource volume_program(const space::Layout& layout, VolumeColour colour, VolumeShading shading,
                             Channels channels);

/// Sets the uniforms of the layout's shader. The program must be in use.
void set_layout(const Program& program, const space::Layout& layout);

/// Direction to the light: above and behind the viewer's left shoulder.
inline glm::vec3 to_light(const space::Camera& camera) {
    const glm::dvec3 right = glm::cross(glm::dvec3(0, 1, 0), camera.forward);
    return glm::vec3(glm::normalize(glm::dvec3(0, 1.4, 0) - camera.forward - 0.4 * right));
}

}  // namespace vvr::gl
