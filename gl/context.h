#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glad/gl.h>

#include "gl/backend.h"

namespace vvr::gl {

/// Hears one message of an OpenGL driver.
using DriverMessages = std::function<void(const std::string&)>;

/// A current OpenGL 3.3 core context without a window, and the functions that came from its own getProcAddress. It is
/// opened, used and closed on one thread.
class Context {
  public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const GladGLContext& gl() const { return gl_; }
    const std::string& backend() const { return backend_; }    ///< its name in the backend table
    const std::string& renderer() const { return renderer_; }  ///< GL_RENDERER
    const std::string& version() const { return version_; }    ///< GL_VERSION

    /// From now on each message of the driver goes to `messages`, within the call that caused it, whatever its
    /// severity. \throws Error backend when the driver has no GL_KHR_debug
    void listen(DriverMessages messages);

  protected:
    /// \param backend its name in the backend table
    explicit Context(std::string backend) : backend_(std::move(backend)) {}

    /// Loads OpenGL's functions, once the context is current.
    /// \param get_proc_address for messages
    /// \param load calls it, with `user` as the first argument
    /// \throws Error backend when there is no OpenGL 3.3
    void finish(std::string_view get_proc_address, GLADuserptrloadfunc load, void* user);

  private:
    GladGLContext gl_{};
    std::string backend_;
    std::string renderer_;
    std::string version_;
    DriverMessages messages_;
};

/// What `vvr doctor` prints of one backend.
struct BackendReport {
    std::string name;
    std::string what;  ///< one line: what it is for
    bool works = false;
    std::string renderer;              ///< GL_RENDERER, when it works
    std::string version;               ///< GL_VERSION, when it works
    std::string reason;                ///< why it doesn't work
    std::string advice;                ///< the one command that would fix it
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

/// A shared library opened at run time. It stays loaded until the program ends.
class Library {
  public:
    /// Opens the first of `names` that is there. \throws Error backend with the loader's own text
    explicit Library(const std::vector<std::string>& names);

    /// The function `name`, cast to its type. \throws Error backend when the library lacks it
    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    std::shared_ptr<void> handle_;
    std::string name_;
};

/// Mesa keeps compiled shaders in the user's folder of caches, and says so on stderr where it can't: for a user without
/// a home, as a service has. There it is told to do without. Elsewhere MESA_SHADER_CACHE_DIR is the folder from then
/// on, for Mesa and for the workers that inherit it: Mesa would ask libc for the user's home, and libc crashes there
/// where memory is short. Changes the environment: call it before any thread.
void choose_shader_cache();

}  // namespace vvr::gl
