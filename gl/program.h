#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "gl/objects.h"

namespace vvr {

/// A linked vertex and fragment shader. Each shader is given as pieces that follow one another after "#version 330".
class Program {
  public:
    /// \param name for messages
    /// \throws Error backend with the compiler's or linker's log
    Program(const GladGLContext& gl, std::string name, std::initializer_list<std::string_view> vertex,
            std::initializer_list<std::string_view> fragment);

    void use() const { gl_->UseProgram(program_.id()); }

    // Uniforms of the program in use; a name that the compiler has optimised away is ignored by OpenGL.
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
    GLint at(const char* uniform) const { return gl_->GetUniformLocation(program_.id(), uniform); }

    const GladGLContext* gl_;
    GlProgram program_;
};

}  // namespace vvr
