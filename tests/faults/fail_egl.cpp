// A libEGL.so.1 for LD_LIBRARY_PATH that lists two devices: a "GPU", which is Mesa's software rasteriser in disguise
// and fails as it is told, and that rasteriser itself, which works.
//
//   VVR_EGL_FAULT=eglCreateContext   this function of the GPU fails; with `all:` before it, of both devices
//   VVR_GL_ERROR=0x505:3             the third glGetError of the GPU says so; 0x507:3+ that one and all later ones
//
// Needs the real library, of which it is told by VVR_REAL_EGL.
#include <array>
#include <cstdlib>
#include <string_view>

#include <dlfcn.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace {

constexpr EGLint error_of_fault = EGL_BAD_ALLOC;

std::string_view asked(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? std::string_view() : text;
}

template <class Function>
Function real(const char* name) {
    static void* const library = dlopen(std::getenv("VVR_REAL_EGL"), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    return reinterpret_cast<Function>(dlsym(library, name));
}

template <class Function>
Function real_extension(const char* name) {
    return reinterpret_cast<Function>(real<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress")(name));
}

EGLDeviceEXT rasteriser() {
    std::array<EGLDeviceEXT, 64> devices{};
    EGLint count = 0;
    real_extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT")(static_cast<EGLint>(devices.size()), devices.data(),
                                                                    &count);
    for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = devices.at(static_cast<std::size_t>(i));
        const char* const extensions =
            real_extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT")(device, EGL_EXTENSIONS);
        if (extensions != nullptr &&
            std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos)
            return device;
    }
    return nullptr;
}

int gpu_place = 0;
const EGLDeviceEXT gpu = &gpu_place;

struct State {
    bool on_gpu = false;  // which device is used now
    bool failed = false;
    long errors_asked = 0;
};
State state;

/// Whether this function is to fail now.
bool fails(std::string_view function) {
    std::string_view fault = asked("VVR_EGL_FAULT");
    const bool both = fault.starts_with("all:");
    if (both) fault.remove_prefix(4);
    state.failed = fault == function && (both || state.on_gpu);
    return state.failed;
}

unsigned get_error() {
    const std::string_view fault = asked("VVR_GL_ERROR");
    if (!fault.empty() && state.on_gpu) {
        const std::size_t colon = fault.find(':');
        const long nth = std::atol(fault.data() + colon + 1);
        const long number = ++state.errors_asked;
        if (number == nth || (fault.ends_with('+') && number > nth)) {
            return static_cast<unsigned>(std::strtoul(fault.data(), nullptr, 16));
        }
    }
    return real_extension<unsigned (*)()>("glGetError")();
}

EGLBoolean query_devices(EGLint most, EGLDeviceEXT* devices, EGLint* count) {
    if (fails("eglQueryDevicesEXT")) return EGL_FALSE;
    *count = 0;
    for (EGLDeviceEXT device : {gpu, rasteriser()}) {
        if (*count < most) devices[(*count)++] = device;
    }
    return EGL_TRUE;
}

const char* query_device_string(EGLDeviceEXT device, EGLint name) {
    if (device == gpu) return name == EGL_EXTENSIONS ? "" : nullptr;
    return real_extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT")(device, name);
}

EGLDisplay get_platform_display(EGLenum platform, void* device, const EGLint* attributes) {
    state.on_gpu = device == gpu;
    if (fails("eglGetPlatformDisplayEXT")) return EGL_NO_DISPLAY;
    return real_extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT")(
        platform, device == gpu ? rasteriser() : device, attributes);
}

}  // namespace

extern "C" {

EGLint eglGetError() {
    return state.failed ? error_of_fault : real<decltype(&eglGetError)>("eglGetError")();
}

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
    using Function = __eglMustCastToProperFunctionPointerType;
    const std::string_view asked_for = name;
    if (asked_for == "eglQueryDevicesEXT")
        return fails("eglGetProcAddress") ? nullptr : reinterpret_cast<Function>(query_devices);
    if (asked_for == "eglQueryDeviceStringEXT") return reinterpret_cast<Function>(query_device_string);
    if (asked_for == "eglGetPlatformDisplayEXT") return reinterpret_cast<Function>(get_platform_display);
    if (asked_for.starts_with("gl") && fails("OpenGL")) return nullptr;
    if (asked_for == "glGetError") return reinterpret_cast<Function>(get_error);
    return real<decltype(&eglGetProcAddress)>("eglGetProcAddress")(name);
}

EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
    return fails("eglInitialize") ? EGL_FALSE : real<decltype(&eglInitialize)>("eglInitialize")(display, major, minor);
}

EGLBoolean eglTerminate(EGLDisplay display) {
    return real<decltype(&eglTerminate)>("eglTerminate")(display);
}

EGLBoolean eglReleaseThread() {
    return real<decltype(&eglReleaseThread)>("eglReleaseThread")();
}

EGLBoolean eglBindAPI(EGLenum api) {
    return fails("eglBindAPI") ? EGL_FALSE : real<decltype(&eglBindAPI)>("eglBindAPI")(api);
}

EGLBoolean eglChooseConfig(EGLDisplay display, const EGLint* attributes, EGLConfig* configs, EGLint size,
                           EGLint* count) {
    if (fails("eglChooseConfig")) return EGL_FALSE;
    return real<decltype(&eglChooseConfig)>("eglChooseConfig")(display, attributes, configs, size, count);
}

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext shared, const EGLint* attributes) {
    if (fails("eglCreateContext")) return EGL_NO_CONTEXT;
    return real<decltype(&eglCreateContext)>("eglCreateContext")(display, config, shared, attributes);
}

EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
    return real<decltype(&eglDestroyContext)>("eglDestroyContext")(display, context);
}

EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
    if (context != EGL_NO_CONTEXT && fails("eglMakeCurrent")) return EGL_FALSE;
    return real<decltype(&eglMakeCurrent)>("eglMakeCurrent")(display, draw, read, context);
}

const char* eglQueryString(EGLDisplay display, EGLint name) {
    return fails("eglQueryString") ? nullptr : real<decltype(&eglQueryString)>("eglQueryString")(display, name);
}

}  // extern "C"
