#pragma once

#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vvr {

/// What went wrong, in the terms of the caller; the command line maps each kind to one exit status.
enum class ErrorKind {
    usage,      ///< a setting has a value that can't be
    io,         ///< a file can't be read or written
    not_video,  ///< the input is not usable video
    backend,    ///< no OpenGL backend, or an OpenGL call failed
    limit,      ///< out of memory, or over a stated limit
    partial,    ///< some of several inputs failed
    differs,    ///< a picture differs from its reference
};

/// The names of at most three settings (core/setting.h) that a text is about. They live as long as the program.
class About {
  public:
    About(std::initializer_list<std::string_view> names = {}) {
        for (std::size_t i = 0; const std::string_view name : names) names_.at(i++) = name;
    }

    const std::array<std::string_view, 3>& names() const { return names_; }  ///< empty where there is none

  private:
    std::array<std::string_view, 3> names_{};
};

/// The one exception of vvr. The text names the file, call or setting, what was asked, what was found, and the next
/// step. It names settings as a person would, "threshold" or "smaller fields"; `about` is for who knows how they are
/// given.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& text, About about = {})
        : std::runtime_error(text), kind_(kind), about_(about) {}

    ErrorKind kind() const { return kind_; }
    const About& about() const { return about_; }

  private:
    ErrorKind kind_;
    About about_;
};

}  // namespace vvr
