#pragma once

#include <stdexcept>
#include <string>

namespace vvr {

/// What kind of thing went wrong.
enum class FailureKind {
    usage,      ///< a setting, or what was passed, has a value that can't be
    io,         ///< a file can't be read or written
    not_video,  ///< the clip is not usable video
    backend,    ///< no OpenGL can be had, or a call of it failed
    limit,      ///< out of memory, or over a stated limit
    bug,        ///< an error that this library should have foreseen
};

/// The one exception that this library throws. what() is UTF-8; it names the file or the setting, what was found, and
/// the next step.
class [[gnu::visibility("default")]] Failure : public std::runtime_error {
  public:
    Failure(FailureKind kind, const std::string& text);
    Failure(const Failure&) = default;
    Failure& operator=(const Failure&) = default;
    ~Failure() override;

    FailureKind kind() const noexcept {
        return kind_;
    }

  private:
    FailureKind kind_;
};

}  // namespace vvr
