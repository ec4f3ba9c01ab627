#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vvr {

/// The kind of an error. The command line maps each kind to one exit status.
enum class ErrorKind {
    usage,      ///< a setting has an invalid value
    io,         ///< a file can't be read or written
    not_video,  ///< the input is not usable video
    backend,    ///< OpenGL or a hardware decoder is missing or failed, or a required sandbox is missing
    limit,      ///< out of memory, or over a stated limit
    partial,    ///< some of several inputs failed
    differs,    ///< a picture differs from its reference
    bug,        ///< an error that vvr does not expect
};

/// The stable code of an error, for programs that act on it; texts may change. Each code has a row of error_rows().
enum class ErrorCode {
    usage,
    command_unknown,
    option_unknown,
    option_value,
    option_value_out_of_range,
    choice_unknown,
    options_conflict,
    option_needs_another,
    config_invalid,
    input_missing,
    input_unsuitable,
    output_missing,
    output_format_unknown,
    output_replaces_input,
    name_pattern_invalid,
    span_empty,
    event_unknown,
    time_of_day_unknown,
    recording_mixed,
    extraction_unsuitable,
    io,
    file_not_found,
    permission_denied,
    disk_full,
    not_a_file,
    not_a_folder,
    folder_not_empty,
    too_many_open_files,
    file_locked,
    file_invalid,
    stream_unreachable,
    stream_timeout,
    archive_empty,
    worker_result_invalid,
    not_a_model,
    not_video,
    file_empty,
    no_video_stream,
    no_frame,
    codec_unsupported,
    playlist,
    copy_impossible,
    backend,
    opengl_unavailable,
    opengl_lost,
    hwaccel_unavailable,
    sandbox_unavailable,
    limit,
    out_of_memory,
    memory_too_small,
    file_too_large,
    picture_too_large,
    worker_start_failed,
    worker_timeout,
    worker_output_limit,
    worker_killed,
    partial,
    picture_differs,
    reference_missing,
    bug,
};

/// The properties of a code. docs/reliability.md has the same table for users.
struct ErrorRow {
    ErrorCode code;
    const char* name;  ///< stable, for logs, sidecars and other programs: "file-not-found"
    ErrorKind kind;
    std::string_view meaning;
};

/// All codes, in the order of ErrorCode.
std::span<const ErrorRow> error_rows();

const ErrorRow& row_of(ErrorCode code);

/// Finds a code by its name.
std::optional<ErrorCode> find_error_code(std::string_view name);

/// The code for the errors of a kind that have no code of their own.
ErrorCode general_code(ErrorKind kind);

/// The code for a system error, a value of errno.
ErrorCode code_of_system_error(int error);

/// The words of the system for it.
std::string text_of_system_error(int error);

/// The names of the settings (core/base/setting.h) that an error is about.
class RelatedSettings {
  public:
    RelatedSettings() = default;
    RelatedSettings(std::initializer_list<std::string_view> names)
        : names_(std::make_shared<std::vector<std::string>>(names.begin(), names.end())) {}

    std::span<const std::string> names() const {
        return names_ ? std::span<const std::string>(*names_) : std::span<const std::string>();
    }

  private:
    std::shared_ptr<const std::vector<std::string>> names_;  ///< shared, so that copying does not throw
};

/// The one exception of vvr. The text names the file, call or setting, what was asked, what was found, and the next
/// step. The text names quantities, such as "threshold". `about` lists their settings, so that the command line can
/// name the options.
class Error : public std::runtime_error {
  public:
    Error(ErrorCode code, const std::string& text, RelatedSettings about = {})
        : std::runtime_error(text), code_(code), about_(about) {}

    ErrorCode code() const { return code_; }
    ErrorKind kind() const { return row_of(code_).kind; }
    const RelatedSettings& about() const { return about_; }

  private:
    ErrorCode code_;
    RelatedSettings about_;
};

/// The error for a call of the system that failed: "FAILED: the system's words; NEXT".
/// \param error a value of errno
/// \param failed "cannot read 'x'"
/// \param next the next step; empty = none
Error system_error(int error, const std::string& failed, std::string_view next = {});

}  // namespace vvr
