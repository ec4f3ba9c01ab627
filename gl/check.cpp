#include "gl/check.h"

#include <cstdint>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr::gl {

namespace {

constexpr GLenum context_lost = 0x0507;  // GL_CONTEXT_LOST, introduced after OpenGL 3.3

std::string_view name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "an unknown error";
    }
}

}  // namespace

void check_gl(const GladGLContext& gl, std::string_view doing) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) return;
    // A lost context reports errors forever, so drain the queue with a bound.
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
    }
    if (error == GL_OUT_OF_MEMORY) {
        throw Error(ErrorCode::out_of_memory,
                    fmt::format("OpenGL ran out of memory while {}; try a smaller picture, smaller fields, or more "
                                "frames per layer",
                                doing),
                    {"size", "field-size", "step"});
    }
    if (error == context_lost) {
        throw Error(
            ErrorCode::opengl_lost,
            fmt::format("OpenGL lost its context (GL_CONTEXT_LOST) while {}: the GPU or its driver was reset; try "
                        "again, or draw with the backend software",
                        doing),
            {"backend"});
    }
    const std::string failure = fmt::format("OpenGL failed with {} ({:#x}) while {}", name(error), error, doing);
    throw_if_out_of_memory(failure);
    throw Error(ErrorCode::backend, failure);
}

void throw_if_out_of_memory(std::string_view failure) {
    constexpr std::int64_t taken = 256'000'000;  // bytes: a driver, its compiler and a small picture
    if (is_memory_available(taken)) return;
    throw Error(ErrorCode::out_of_memory,
                fmt::format("out of memory for OpenGL: {}; allow the program more, or try a smaller picture or smaller "
                            "fields",
                            failure),
                {"size", "field-size"});
}

}  // namespace vvr::gl
