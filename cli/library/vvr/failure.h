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
    /// \param code a text that stays where it is
    Failure(FailureKind kind, const char* code, const std::string& text);
    Failure(const Failure&) = default;
    Failure& operator=(const Failure&) = default;
    ~Failure() override;

    FailureKind kind() const noexcept {
        return kind_;
    }

    /// What went wrong, more closely than its kind: "file-not-found". docs/reliability.md lists the codes; there may be
    /// more of them in later versions.
    const char* code() const noexcept {
        return code_;
    }

  private:
    FailureKind kind_;
    const char* code_;
};

}  // namespace vvr
