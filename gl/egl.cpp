#include <array>
#include <cstring>
#include <optional>
#include <string_view>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "gl/context.h"

namespace vvr::gl {

namespace {

/// The functions of libEGL that we call. Extensions are loaded through eglGetProcAddress.
struct Egl {
    Library library{{"libEGL.so.1", "libEGL.so"}};

    PFNEGLGETPROCADDRESSPROC get_proc_address = library.function<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");
    PFNEGLINITIALIZEPROC initialize = library.function<PFNEGLINITIALIZEPROC>("eglInitialize");
    PFNEGLRELEASETHREADPROC release_thread = library.function<PFNEGLRELEASETHREADPROC>("eglReleaseThread");
    PFNEGLBINDAPIPROC bind_api = library.function<PFNEGLBINDAPIPROC>("eglBindAPI");
    PFNEGLCHOOSECONFIGPROC choose_config = library.function<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig");
    PFNEGLCREATECONTEXTPROC create_context = library.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
    PFNEGLDESTROYCONTEXTPROC destroy_context = library.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
    PFNEGLMAKECURRENTPROC make_current = library.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
    PFNEGLQUERYSTRINGPROC query_string = library.function<PFNEGLQUERYSTRINGPROC>("eglQueryString");
    PFNEGLGETERRORPROC get_error = library.function<PFNEGLGETERRORPROC>("eglGetError");

    PFNEGLQUERYDEVICESEXTPROC query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string =
        extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
        extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");

    template <class Function>
    Function extension(const char* name) const {
        return reinterpret_cast<Function>(get_proc_address(name));
    }
};

bool has_word(const char* list, std::string_view word) {
    if (list == nullptr) return false;
    const std::string padded = fmt::format(" {} ", list);
    return padded.find(fmt::format(" {} ", word)) != std::string::npos;
}

struct Device {
    EGLDeviceEXT handle = nullptr;
    bool software = false;
    std::string name;
};

std::vector<Device> list_devices(const Egl& egl) {
    if (egl.query_devices == nullptr || egl.query_device_string == nullptr || egl.get_platform_display == nullptr) {
        throw Error(ErrorCode::opengl_unavailable, "libEGL cannot list devices: it lacks EGL_EXT_device_enumeration");
    }
    std::array<EGLDeviceEXT, 64> handles{};
    EGLint count = 0;
    const auto most = static_cast<EGLint>(handles.size());
    if (!while_loading([&] { return egl.query_devices(most, handles.data(), &count); })) {
        throw Error(ErrorCode::opengl_unavailable,
                    fmt::format("eglQueryDevicesEXT failed (EGL error {:#x})", egl.get_error()));
    }
    std::vector<Device> devices;
    for (EGLint i = 0; i < count; ++i) {
        Device device;
        device.handle = handles.at(static_cast<std::size_t>(i));
        const char* extensions = egl.query_device_string(device.handle, EGL_EXTENSIONS);
        device.software = has_word(extensions, "EGL_MESA_device_software");
        const char* node = has_word(extensions, "EGL_EXT_device_drm")
                               ? egl.query_device_string(device.handle, EGL_DRM_DEVICE_FILE_EXT)
                               : nullptr;
        device.name = device.software ? "software rasteriser" : (node != nullptr ? node : "hardware");
        devices.push_back(std::move(device));
    }
    return devices;
}

class EglContext final : public Context {
  public:
    EglContext(std::string backend, Egl egl, const Device& device, bool debug)
        : Context(std::move(backend)), egl_(std::move(egl)) {
        display_ =
            while_loading([&] { return egl_.get_platform_display(EGL_PLATFORM_DEVICE_EXT, device.handle, nullptr); });
        if (display_ == EGL_NO_DISPLAY) fail("eglGetPlatformDisplayEXT");
        if (!while_loading([&] { return egl_.initialize(display_, nullptr, nullptr); })) fail("eglInitialize");
        try {
            create(debug);
        } catch (...) {
            close();
            throw;
        }
    }
    ~EglContext() override { close(); }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

  private:
    void create(bool debug) {
        if (!has_word(egl_.query_string(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
            throw Error(ErrorCode::opengl_unavailable, "the driver lacks EGL_KHR_surfaceless_context");
        }
        if (!egl_.bind_api(EGL_OPENGL_API)) fail("eglBindAPI(EGL_OPENGL_API)");
        const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                              EGL_NONE};
        EGLConfig config = nullptr;
        EGLint configs = 0;
        if (!egl_.choose_config(display_, wanted.data(), &config, 1, &configs)) fail("eglChooseConfig");
        if (configs == 0)
            throw Error(ErrorCode::opengl_unavailable, "eglChooseConfig found no configuration with desktop OpenGL");

        // The flags come last, so that drivers that don't know them see them only in debug contexts.
        const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_MINOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                  debug ? EGL_CONTEXT_FLAGS_KHR : EGL_NONE,
                                                  EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                                                  EGL_NONE};
        context_ =
            while_loading([&] { return egl_.create_context(display_, config, EGL_NO_CONTEXT, attributes.data()); });
        if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext (OpenGL 3.3 core)");
        if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("eglMakeCurrent");

        const auto load = [](void* user, const char* name) -> GLADapiproc {
            return reinterpret_cast<GLADapiproc>(static_cast<Egl*>(user)->get_proc_address(name));
        };
        finish("eglGetProcAddress", load, &egl_);
    }

    /// Leaves the display open: it is the same one for all threads of the process, which may be drawing, and EGL does
    /// not count who opened it.
    void close() {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) egl_.destroy_context(display_, context_);
        egl_.release_thread();
    }

    [[noreturn]] void fail(const char* call) const {
        throw Error(ErrorCode::opengl_unavailable, fmt::format("{} failed (EGL error {:#x})", call, egl_.get_error()));
    }

    Egl egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

std::vector<std::string> device_names() {
    std::vector<std::string> names;
    for (const Device& device : list_devices(Egl{})) names.push_back(device.name);
    return names;
}

/// Opens the first device of the requested kind that works, or device `number` if it is not negative.
std::unique_ptr<Context> open_kind(const std::string& backend, bool software, int number, bool debug) {
    const std::vector<Device> devices = list_devices(Egl{});
    if (number >= static_cast<int>(devices.size())) {
        throw Error(ErrorCode::opengl_unavailable,
                    fmt::format("there is no EGL device {}: found {}, counted from 0", number, devices.size()));
    }
    std::vector<std::string> tried;
    for (int i = 0; i < static_cast<int>(devices.size()); ++i) {
        const Device& device = devices[static_cast<std::size_t>(i)];
        if (number >= 0 && number != i) continue;
        if (device.software != software) {
            if (number == i) tried.push_back(fmt::format("device {} is {}", i, device.name));
            continue;
        }
        try {
            return std::make_unique<EglContext>(backend, Egl{}, device, debug);
        } catch (const Error& error) {
            tried.push_back(fmt::format("device {} ({}): {}", i, device.name, error.what()));
        }
    }
    if (tried.empty()) {
        throw Error(ErrorCode::opengl_unavailable,
                    fmt::format("no EGL device is a {} (found: {})", software ? "software rasteriser" : "GPU",
                                counted(std::ssize(devices), "device")));
    }
    throw Error(ErrorCode::opengl_unavailable, fmt::format("{}", fmt::join(tried, "; ")));
}

}  // namespace

Backend egl_hardware_backend() {
    return {"egl",
            "a GPU through EGL, no display needed",
            [](int device, bool debug) { return open_kind("egl", false, device, debug); },
            device_names,
            "install the GPU vendor's driver with its EGL library (Mesa's: apt-get install libegl1 libegl-mesa0 "
            "libgl1-mesa-dri)",
            true};
}

Backend egl_software_backend() {
    return {"software", "Mesa's software rasteriser through EGL, on any CPU",
            [](int device, bool debug) { return open_kind("software", true, device, debug); }, device_names,
            "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri"};
}

}  // namespace vvr::gl
