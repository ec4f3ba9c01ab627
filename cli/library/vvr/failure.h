#pragma once

#include <stdexcept>
#include <string>

namespace vvr {

/// The category of an error.
enum class FailureKind {
    usage,      ///< a setting or argument has an invalid value
    io,         ///< a file can't be read or written
    not_video,  ///< the clip is not usable video
    backend,    ///< OpenGL is not available or failed
    limit,      ///< out of memory, or over a stated limit
    bug,        ///< an error that this library should have foreseen
};

/// The only exception that this library throws. what() is UTF-8. It names the file or setting, what was found, and the
/// next step.
class [[gnu::visibility("default")]] Failure : public std::runtime_error {
  public:
    /// \param code a string with static storage duration
    Failure(FailureKind kind, const char* code, const std::string& text);
    Failure(const Failure&) = default;
    Failure& operator=(const Failure&) = default;
    ~Failure() override;

    FailureKind kind() const noexcept {
        return kind_;
    }

    /// The exact error, such as "file-not-found". docs/reliability.md lists the codes; later versions may add some.
    const char* code() const noexcept {
        return code_;
    }

  private:
    FailureKind kind_;
    const char* code_;
};

}  // namespace vvr
