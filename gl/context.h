#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glad/gl.h>

#include "core/base/setting.h"

namespace vvr::gl {

class Context;

/// One way to get an OpenGL context.
struct Backend {
    std::string name;
    std::string help;
    std::unique_ptr<Context> (*open)(int device, bool debug) = nullptr;  ///< null = the first other one that works
    std::vector<std::string> (*devices)() = nullptr;  ///< in the order of `device`; empty for a backend without devices
    std::string advice{};                             ///< the command that makes it work on Debian
    bool gpu = false;                                 ///< opens the devices of a graphics card
};

/// All backends; the first is "auto", which tries the others in order.
const std::vector<Backend>& backends();

Backend egl_hardware_backend();
Backend egl_software_backend();
Backend osmesa_backend();

const Backend& row_of(Name<Backend> name);

/// Receives one debug message of an OpenGL driver.
using DriverMessages = std::function<void(const std::string&)>;

/// A current OpenGL 3.3 core context without a window, and its functions, loaded through its own getProcAddress. Open,
/// use and close it on one thread.
class Context {
  public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const GladGLContext& gl() const { return gl_; }
    const std::string& backend() const { return backend_; }    ///< name in the backend table
    const std::string& renderer() const { return renderer_; }  ///< GL_RENDERER
    const std::string& version() const { return version_; }    ///< GL_VERSION

    /// Sends all debug messages of the driver to `messages`, synchronously, whatever their severity.
    /// \throws Error backend if the driver lacks GL_KHR_debug
    void listen(DriverMessages messages);

  protected:
    /// \param backend name in the backend table
    explicit Context(std::string backend) : backend_(std::move(backend)) {}

    /// Loads the OpenGL functions. The context must be current.
    /// \param get_proc_address name of the loading function, for messages
    /// \param load calls that function; its first argument is `user`
    /// \throws Error backend if OpenGL 3.3 is missing
    void finish(std::string_view get_proc_address, GLADuserptrloadfunc load, void* user);

  private:
    GladGLContext gl_{};
    std::string backend_;
    std::string renderer_;
    std::string version_;
    DriverMessages messages_;
};

/// Throws if OpenGL has recorded an error since the last check.
/// \param doing the operation, for the message
/// \throws Error limit if OpenGL ran out of memory, backend for any other error
void check_gl(const GladGLContext& gl, std::string_view doing);

/// Drivers report arbitrary errors when memory is short. Throws if the process can't allocate what OpenGL needs at
/// startup, otherwise does nothing.
/// \param failure the driver's message
/// \throws Error limit
void throw_if_out_of_memory(std::string_view failure);

/// What `vvr doctor` prints about a backend.
struct BackendReport {
    std::string name;
    std::string what;  ///< its purpose, in one line
    bool works = false;
    std::string renderer;              ///< GL_RENDERER if it works
    std::string version;               ///< GL_VERSION if it works
    std::string reason;                ///< why it fails
    std::string advice;                ///< the command that would fix it
    std::vector<std::string> devices;  ///< EGL devices by number, for the EGL backends
};

/// Opens a context.
/// \param device number of an EGL device among those that `probe_backends` lists, or -1 for the first that works
/// \param messages if given, the context is a debug context, and its driver's messages go here
/// \throws Error backend, with every attempt and why it failed, when there is none
std::unique_ptr<Context> open_context(const Choice<Backend>& backend = "auto", int device = -1,
                                      DriverMessages messages = {});

/// Whether a backend may open the devices of a graphics card.
bool may_use_gpu(const Backend& backend);

/// Tries each backend in turn.
std::vector<BackendReport> probe_backends();

/// A shared library loaded at run time. It stays loaded until the process exits.
class Library {
  public:
    /// Loads the first of `names` that exists.
    /// \throws Error backend with the loader's message
    explicit Library(const std::vector<std::string>& names);

    /// \throws Error backend if the library lacks the function
    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    std::shared_ptr<void> handle_;
    std::string name_;
};

}  // namespace vvr::gl
