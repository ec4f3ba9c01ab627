#include <array>
#include <cstdint>
#include <memory>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "gl/context.h"

namespace vvr::gl {

namespace {

// The part of <GL/osmesa.h> that we use. Mesa 25.1 removed the header's package; the ABI is stable.
using OSMesaHandle = struct osmesa_context*;
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major = 0x36;
constexpr int osmesa_minor = 0x37;

struct OSMesa {
    Library library{{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}};

    using Create = OSMesaHandle (*)(const int*, OSMesaHandle);
    using Destroy = void (*)(OSMesaHandle);
    using MakeCurrent = unsigned char (*)(OSMesaHandle, void*, unsigned, int, int);
    using GetProcAddress = void (*(*)(const char*))();

    Create create = library.function<Create>("OSMesaCreateContextAttribs");
    Destroy destroy = library.function<Destroy>("OSMesaDestroyContext");
    MakeCurrent make_current = library.function<MakeCurrent>("OSMesaMakeCurrent");
    GetProcAddress get_proc_address = library.function<GetProcAddress>("OSMesaGetProcAddress");
};

class OSMesaContext final : public Context {
  public:
    OSMesaContext() : Context("osmesa") {
        constexpr std::array attributes = {osmesa_format,
                                           GL_RGBA,
                                           osmesa_depth_bits,
                                           0,
                                           osmesa_profile,
                                           osmesa_core_profile,
                                           osmesa_major,
                                           3,
                                           osmesa_minor,
                                           3,
                                           0};
        handle_.reset(while_loading([&] { return mesa_.create(attributes.data(), nullptr); }));
        if (!handle_) throw Error(ErrorCode::opengl_unavailable, "OSMesaCreateContextAttribs (OpenGL 3.3 core) failed");
        if (!mesa_.make_current(handle_.get(), surface_.data(), GL_UNSIGNED_BYTE, side, side)) {
            throw Error(ErrorCode::opengl_unavailable, "OSMesaMakeCurrent failed");
        }
        const auto load = [](void* user, const char* name) -> GLADapiproc {
            return static_cast<OSMesa*>(user)->get_proc_address(name);
        };
        finish("OSMesaGetProcAddress", load, &mesa_);
    }

  private:
    // OSMesa needs a colour buffer. We draw into framebuffer objects, so a tiny one suffices.
    static constexpr int side = 4;

    OSMesa mesa_;
    std::unique_ptr<osmesa_context, OSMesa::Destroy> handle_{nullptr, mesa_.destroy};
    std::array<std::uint8_t, std::size_t{4} * side * side> surface_{};
};

}  // namespace

Backend osmesa_backend() {
    return {"osmesa", "Mesa's software rasteriser through OSMesa, for machines without EGL",
            [](int device, bool /*debug*/) -> std::unique_ptr<Context> {
                if (device >= 0) throw Error(ErrorCode::opengl_unavailable, "OSMesa has no devices to choose from");
                return std::make_unique<OSMesaContext>();
            },
            []() { return std::vector<std::string>{}; }, "apt-get install libosmesa6"};
}

}  // namespace vvr::gl
