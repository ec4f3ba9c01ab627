#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vvr {

/// What went wrong, in the terms of the caller; the command line maps each kind to one exit status.
enum class ErrorKind {
    usage,      ///< a setting has a value that can't be
    io,         ///< a file can't be read or written
    not_video,  ///< the input is not usable video
    backend,    ///< no OpenGL backend, or an OpenGL call failed; or no sandbox where one is required
    limit,      ///< out of memory, or over a stated limit
    partial,    ///< some of several inputs failed
    differs,    ///< a picture differs from its reference
};

/// The names of the settings (core/base/setting.h) that a text is about.
class RelatedSettings {
  public:
    RelatedSettings() = default;
    RelatedSettings(std::initializer_list<std::string_view> names)
        : names_(std::make_shared<std::vector<std::string>>(names.begin(), names.end())) {}

    std::span<const std::string> names() const {
        return names_ ? std::span<const std::string>(*names_) : std::span<const std::string>();
    }

  private:
    std::shared_ptr<const std::vector<std::string>> names_;  ///< shared, so that a copy throws nothing
};

/// The one exception of vvr. The text names the file, call or setting, what was asked, what was found, and the next
/// step. It names settings as a person would, "threshold" or "smaller fields"; `about` is for who knows how they are
/// given.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& text, RelatedSettings about = {})
        : std::runtime_error(text), kind_(kind), about_(about) {}

    ErrorKind kind() const { return kind_; }
    const RelatedSettings& about() const { return about_; }

  private:
    ErrorKind kind_;
    RelatedSettings about_;
};

}  // namespace vvr
