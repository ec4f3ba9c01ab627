#include "gl/context.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <dlfcn.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr::gl {

namespace {

struct NamedValue {
    GLenum value;
    std::string_view name;
};

constexpr std::array message_kinds = {
    NamedValue{GL_DEBUG_TYPE_ERROR, "error"},
    NamedValue{GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR, "deprecated"},
    NamedValue{GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, "undefined behaviour"},
    NamedValue{GL_DEBUG_TYPE_PORTABILITY, "portability"},
    NamedValue{GL_DEBUG_TYPE_PERFORMANCE, "performance"},
};

void GLAD_API_PTR forward_message(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/, GLsizei length,
                                  const GLchar* text, const void* messages) {
    const auto* kind = std::ranges::find(message_kinds, type, &NamedValue::value);
    (*static_cast<const DriverMessages*>(messages))(
        fmt::format("OpenGL, {}: {}", kind != message_kinds.end() ? kind->name : "note",
                    std::string_view(text, static_cast<std::size_t>(length))));
}

constexpr GLenum context_lost = 0x0507;  // GL_CONTEXT_LOST, introduced after OpenGL 3.3

constexpr std::array errors = {
    NamedValue{GL_INVALID_ENUM, "GL_INVALID_ENUM"},
    NamedValue{GL_INVALID_VALUE, "GL_INVALID_VALUE"},
    NamedValue{GL_INVALID_OPERATION, "GL_INVALID_OPERATION"},
    NamedValue{GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION"},
};

}  // namespace

void Context::finish(std::string_view get_proc_address, GLADuserptrloadfunc load, void* user) {
    if (!gladLoadGLContextUserPtr(&gl_, load, user)) {
        throw Error(ErrorCode::opengl_unavailable, fmt::format("{} returns no OpenGL 3.3 functions", get_proc_address));
    }
    renderer_ = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    version_ = reinterpret_cast<const char*>(gl_.GetString(GL_VERSION));
    // llvmpipe has started its threads by now. The first picture would wait forever for one that it could not start.
    if (renderer_.starts_with("llvmpipe")) check_threads(1);
}

void Context::listen(DriverMessages messages) {
    if (!gl_.KHR_debug) throw Error(ErrorCode::backend, "the driver lacks GL_KHR_debug, so vvr can't log its messages");
    messages_ = std::move(messages);
    gl_.Enable(GL_DEBUG_OUTPUT);
    gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl_.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    gl_.DebugMessageCallback(forward_message, &messages_);
}

const std::vector<Backend>& backends() {
    static const std::vector<Backend> rows{
        {"auto", "the first of these that works"}, egl_hardware_backend(), egl_software_backend(), osmesa_backend()};
    return rows;
}

std::unique_ptr<Context> open_context(const Choice<Backend>& chosen, int device, DriverMessages messages) {
    std::string tried;
    for (const Backend& backend : backends()) {
        if (backend.open == nullptr || (chosen->open != nullptr && chosen != backend)) continue;
        try {
            std::unique_ptr<Context> context = backend.open(device, messages != nullptr);
            if (messages) context->listen(std::move(messages));
            return context;
        } catch (const Error& error) {
            tried += fmt::format("{}{}: {}", tried.empty() ? "" : "; ", backend.name, error.what());
        }
    }
    throw_if_out_of_memory(fmt::format("no context from {}", tried));
    throw Error(ErrorCode::opengl_unavailable,
                fmt::format("no OpenGL context from backend {}{}; tried {}; run `vvr doctor` to see how to fix it",
                            chosen->name, device < 0 ? "" : fmt::format(", device {}", device), tried));
}

bool may_use_gpu(const Backend& backend) {
    return backend.open == nullptr ? std::ranges::any_of(backends(), &Backend::gpu) : backend.gpu;
}

std::vector<BackendReport> probe_backends() {
    std::vector<BackendReport> reports;
    for (const Backend& backend : backends()) {
        if (backend.open == nullptr) continue;
        BackendReport report;
        report.name = backend.name;
        report.what = backend.help;
        try {
            report.devices = backend.devices();
            const auto context = backend.open(-1, false);
            report.works = true;
            report.renderer = context->renderer();
            report.version = context->version();
        } catch (const Error& error) {
            report.reason = error.what();
            report.advice = backend.advice;
        }
        reports.push_back(std::move(report));
    }
    return reports;
}

void check_gl(const GladGLContext& gl, std::string_view doing) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) return;
    // A lost context reports errors forever, so drain the queue with a bound.
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
    }
    if (error == GL_OUT_OF_MEMORY) {
        throw Error(ErrorCode::out_of_memory,
                    fmt::format("OpenGL ran out of memory while {}; choose a smaller picture, smaller fields, or "
                                "more frames per layer",
                                doing),
                    {"size", "field-size", "step"});
    }
    if (error == context_lost) {
        throw Error(
            ErrorCode::opengl_lost,
            fmt::format("OpenGL lost its context (GL_CONTEXT_LOST) while {}: the GPU or its driver was reset; try "
                        "again, or use the backend 'software'",
                        doing),
            {"backend"});
    }
    const auto* const known = std::ranges::find(errors, error, &NamedValue::value);
    const std::string failure = fmt::format("OpenGL failed with {} ({:#x}) while {}",
                                            known != errors.end() ? known->name : "an unknown error", error, doing);
    throw_if_out_of_memory(failure);
    throw Error(ErrorCode::backend, failure);
}

void throw_if_out_of_memory(std::string_view failure) {
    constexpr std::int64_t taken = 256'000'000;  // bytes: a driver, its compiler and a small picture
    if (is_memory_available(taken)) return;
    throw Error(
        ErrorCode::out_of_memory,
        fmt::format("out of memory for OpenGL: {}; give vvr more memory, or choose a smaller picture or smaller fields",
                    failure),
        {"size", "field-size"});
}

Library::Library(const std::vector<std::string>& names) {
    std::string why;
    for (const std::string& name : names) {
        // Mesa and LLVM register exit handlers. With some drivers a real dlclose makes them crash at exit.
        constexpr int how = RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE;
        if (void* handle = while_loading([&] { return dlopen(name.c_str(), how); })) {
            handle_ = std::shared_ptr<void>(handle, [](void* library) { dlclose(library); });
            name_ = name;
            return;
        }
        why = dlerror();
    }
    throw Error(ErrorCode::opengl_unavailable, fmt::format("cannot load {}: {}", fmt::join(names, " or "), why));
}

void* Library::symbol(const char* name) const {
    void* address = dlsym(handle_.get(), name);
    if (address == nullptr)
        throw Error(ErrorCode::opengl_unavailable, fmt::format("{} has no function {}", name_, name));
    return address;
}

const Backend& row_of(Name<Backend> name) {
    return choose("backend", name.text, backends());
}

}  // namespace vvr::gl
