#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "gl/objects.h"

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
