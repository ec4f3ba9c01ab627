#pragma once

#include <stdexcept>
#include <string>

namespace vvr {

/// What went wrong, in the terms of the caller; the command line maps each kind to one exit status.
enum class ErrorKind {
    usage,      ///< the command line or a config file asks for something that can't be
    io,         ///< a file can't be read or written
    not_video,  ///< the input is not usable video
    backend,    ///< no OpenGL backend, or an OpenGL call failed
    limit,      ///< out of memory, or over a stated limit
    partial,    ///< some of several inputs failed
    differs,    ///< a picture differs from its reference
};

/// The one exception of vvr. The text names the file or call, what was asked, what was found, and the next step.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& text) : std::runtime_error(text), kind_(kind) {}

    ErrorKind kind() const { return kind_; }

  private:
    ErrorKind kind_;
};

}  // namespace vvr
