#include "gl/context.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/choice.h"
#include "core/error.h"
#include "gl/backend.h"

namespace vvr {

namespace {

std::vector<Backend> backends() {
    return {egl_hardware_backend(), egl_software_backend(), osmesa_backend()};
}

}  // namespace

void Context::finish(std::string_view get_proc_address, GLADuserptrloadfunc load, void* user) {
    if (!gladLoadGLContextUserPtr(&gl_, load, user)) {
        throw Error(ErrorKind::backend, fmt::format("{} gives no OpenGL 3.3 functions", get_proc_address));
    }
    renderer_ = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    version_ = reinterpret_cast<const char*>(gl_.GetString(GL_VERSION));
}

std::unique_ptr<Context> open_context(std::string_view name, int device) {
    std::string tried;
    for (const Backend& backend : backends()) {
        if (name != "auto" && name != backend.name) continue;
        try {
            return backend.open(device);
        } catch (const Error& error) {
            tried += fmt::format("\n  {}: {}", backend.name, error.what());
        }
    }
    if (tried.empty()) refuse_choice("backend", name, backend_names());
    throw Error(ErrorKind::backend,
                fmt::format("no OpenGL context from backend {}{}; tried:{}\n`vvr doctor` says how to fix it", name,
                            device < 0 ? "" : fmt::format(", device {}", device), tried));
}

std::vector<std::string> backend_names() {
    std::vector<std::string> names = {"auto"};
    for (const Backend& backend : backends()) names.push_back(backend.name);
    return names;
}

std::vector<BackendReport> probe_backends() {
    std::vector<BackendReport> reports;
    for (const Backend& backend : backends()) {
        BackendReport report;
        report.name = backend.name;
        report.what = backend.what;
        try {
            report.devices = backend.devices();
            const auto context = backend.open(-1);
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

}  // namespace vvr
