#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace vvr {

namespace {

constexpr std::array rows{
    ErrorRow{ErrorCode::usage, "usage", ErrorKind::usage,
             "the command line or a call of the library requests something impossible"},
    ErrorRow{ErrorCode::command_unknown, "command-unknown", ErrorKind::usage, "no command has this name"},
    ErrorRow{ErrorCode::option_unknown, "option-unknown", ErrorKind::usage, "no option or setting has this name"},
    ErrorRow{ErrorCode::option_value, "option-value", ErrorKind::usage, "the value of a setting has the wrong format"},
    ErrorRow{ErrorCode::option_value_out_of_range, "option-value-out-of-range", ErrorKind::usage,
             "the value of a setting is out of range"},
    ErrorRow{ErrorCode::choice_unknown, "choice-unknown", ErrorKind::usage,
             "the value of a setting is not one of its names"},
    ErrorRow{ErrorCode::options_conflict, "options-conflict", ErrorKind::usage,
             "two settings, or a setting and the kind of output, exclude each other"},
    ErrorRow{ErrorCode::option_needs_another, "option-needs-another", ErrorKind::usage,
             "a setting has no effect without another one, which is missing"},
    ErrorRow{ErrorCode::config_invalid, "config-invalid", ErrorKind::usage,
             "a config file has an unknown section or name"},
    ErrorRow{ErrorCode::input_missing, "input-missing", ErrorKind::usage, "no input is given"},
    ErrorRow{ErrorCode::input_unsuitable, "input-unsuitable", ErrorKind::usage,
             "the command does not accept this input, or this number of inputs"},
    ErrorRow{ErrorCode::output_missing, "output-missing", ErrorKind::usage, "no output is given"},
    ErrorRow{ErrorCode::output_format_unknown, "output-format-unknown", ErrorKind::usage,
             "vvr cannot write files with this extension"},
    ErrorRow{ErrorCode::output_replaces_input, "output-replaces-input", ErrorKind::usage,
             "an output would replace a file that vvr reads"},
    ErrorRow{ErrorCode::name_pattern_invalid, "name-pattern-invalid", ErrorKind::usage,
             "a pattern of file names has the wrong format"},
    ErrorRow{ErrorCode::span_empty, "span-empty", ErrorKind::usage, "there is no frame between the start and the end"},
    ErrorRow{ErrorCode::event_unknown, "event-unknown", ErrorKind::usage, "the clip has no event with this number"},
    ErrorRow{ErrorCode::time_of_day_unknown, "time-of-day-unknown", ErrorKind::usage,
             "the time of the recording is unknown"},
    ErrorRow{ErrorCode::recording_mixed, "recording-mixed", ErrorKind::usage,
             "the files do not belong to one recording"},
    ErrorRow{ErrorCode::extraction_unsuitable, "extraction-unsuitable", ErrorKind::usage,
             "extracted data lack what the settings need, or come from different runs"},
    ErrorRow{ErrorCode::io, "io", ErrorKind::io,
             "a file cannot be read or written, for another reason than those below"},
    ErrorRow{ErrorCode::file_not_found, "file-not-found", ErrorKind::io, "a file or folder does not exist"},
    ErrorRow{ErrorCode::permission_denied, "permission-denied", ErrorKind::io,
             "the permissions deny the use of a file or folder, or it is read-only"},
    ErrorRow{ErrorCode::disk_full, "disk-full", ErrorKind::io,
             "the disk is full, or a quota or the maximum file size is reached"},
    ErrorRow{ErrorCode::not_a_file, "not-a-file", ErrorKind::io,
             "a folder, a link, a device or a pipe is in the place of a file"},
    ErrorRow{ErrorCode::not_a_folder, "not-a-folder", ErrorKind::io,
             "a file, a link, a device or a pipe is in the place of a folder"},
    ErrorRow{ErrorCode::folder_not_empty, "folder-not-empty", ErrorKind::io,
             "a folder has files that vvr did not write"},
    ErrorRow{ErrorCode::too_many_open_files, "too-many-open-files", ErrorKind::io,
             "the limit of open files is reached"},
    ErrorRow{ErrorCode::file_locked, "file-locked", ErrorKind::io, "another program holds the lock of a file"},
    ErrorRow{ErrorCode::file_invalid, "file-invalid", ErrorKind::io,
             "a list, a data file or a report has the wrong format"},
    ErrorRow{ErrorCode::stream_unreachable, "stream-unreachable", ErrorKind::io,
             "an address does not answer, or redirects to another one"},
    ErrorRow{ErrorCode::stream_timeout, "stream-timeout", ErrorKind::io, "a stream sent nothing in time"},
    ErrorRow{ErrorCode::archive_empty, "archive-empty", ErrorKind::io,
             "an archive has no clips, so vvr does not remove its pictures"},
    ErrorRow{ErrorCode::worker_result_invalid, "worker-result-invalid", ErrorKind::io,
             "a worker of an archive ended with an unknown status, without its files, or with an invalid report"},
    ErrorRow{ErrorCode::not_a_model, "not-a-model", ErrorKind::io,
             "a file is not a detector model, is damaged, or has a format that vvr does not know"},
    ErrorRow{ErrorCode::not_video, "not-video", ErrorKind::not_video, "the input is not a video that vvr can decode"},
    ErrorRow{ErrorCode::file_empty, "file-empty", ErrorKind::not_video, "the input is empty"},
    ErrorRow{ErrorCode::no_video_stream, "no-video-stream", ErrorKind::not_video,
             "the input is a media file without video"},
    ErrorRow{ErrorCode::no_frame, "no-frame", ErrorKind::not_video,
             "the input has video, but no frame of it can be decoded"},
    ErrorRow{ErrorCode::codec_unsupported, "codec-unsupported", ErrorKind::not_video,
             "this FFmpeg has no decoder for the video"},
    ErrorRow{ErrorCode::playlist, "playlist", ErrorKind::not_video, "the input is a playlist, not a video"},
    ErrorRow{ErrorCode::copy_impossible, "copy-impossible", ErrorKind::not_video,
             "the video cannot be cut without encoding it again"},
    ErrorRow{ErrorCode::backend, "backend", ErrorKind::backend, "OpenGL failed, for another reason than those below"},
    ErrorRow{ErrorCode::opengl_unavailable, "opengl-unavailable", ErrorKind::backend,
             "the backend cannot create an OpenGL context"},
    ErrorRow{ErrorCode::opengl_lost, "opengl-lost", ErrorKind::backend, "the GPU or its driver was reset"},
    ErrorRow{ErrorCode::hwaccel_unavailable, "hwaccel-unavailable", ErrorKind::backend,
             "the hardware that is to decode can't be opened, or failed"},
    ErrorRow{ErrorCode::sandbox_unavailable, "sandbox-unavailable", ErrorKind::backend,
             "the kernel does not support the required sandbox"},
    ErrorRow{ErrorCode::limit, "limit", ErrorKind::limit, "a limit is reached, for another reason than those below"},
    ErrorRow{ErrorCode::out_of_memory, "out-of-memory", ErrorKind::limit,
             "vvr cannot allocate memory or start a thread"},
    ErrorRow{ErrorCode::memory_too_small, "memory-too-small", ErrorKind::limit,
             "the run needs more memory than the machine has"},
    ErrorRow{ErrorCode::file_too_large, "file-too-large", ErrorKind::limit,
             "a file is larger than the limit for its kind"},
    ErrorRow{ErrorCode::picture_too_large, "picture-too-large", ErrorKind::limit,
             "a picture, a field or a texture has too many pixels"},
    ErrorRow{ErrorCode::worker_start_failed, "worker-start-failed", ErrorKind::limit,
             "a worker of an archive cannot be started"},
    ErrorRow{ErrorCode::worker_timeout, "worker-timeout", ErrorKind::limit, "a worker of an archive took too long"},
    ErrorRow{ErrorCode::worker_output_limit, "worker-output-limit", ErrorKind::limit,
             "a worker of an archive wrote too much"},
    ErrorRow{ErrorCode::worker_killed, "worker-killed", ErrorKind::limit,
             "a signal ended a worker of an archive; its sidecar has 128 plus the signal as status"},
    ErrorRow{ErrorCode::partial, "partial", ErrorKind::partial, "some of several inputs failed"},
    ErrorRow{ErrorCode::picture_differs, "picture-differs", ErrorKind::differs, "a picture differs from its reference"},
    ErrorRow{ErrorCode::reference_missing, "reference-missing", ErrorKind::differs,
             "there is no reference picture to compare with"},
    ErrorRow{ErrorCode::bug, "bug", ErrorKind::bug, "an error that vvr does not expect"},
};

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (static_cast<std::size_t>(rows[i].code) != i) return false;
    }
    return static_cast<std::size_t>(ErrorCode::bug) + 1 == rows.size();
}
static_assert(is_in_order(), "a code's row is found by its number");

constexpr std::array system_errors{
    std::pair{ENOENT, ErrorCode::file_not_found},
    std::pair{EACCES, ErrorCode::permission_denied},
    std::pair{EPERM, ErrorCode::permission_denied},
    std::pair{EROFS, ErrorCode::permission_denied},
    std::pair{ENOSPC, ErrorCode::disk_full},
    std::pair{EDQUOT, ErrorCode::disk_full},
    std::pair{EFBIG, ErrorCode::disk_full},
    std::pair{EISDIR, ErrorCode::not_a_file},
    std::pair{ENOTDIR, ErrorCode::not_a_folder},
    std::pair{EMFILE, ErrorCode::too_many_open_files},
    std::pair{ENFILE, ErrorCode::too_many_open_files},
};

}  // namespace

std::span<const ErrorRow> error_rows() {
    return rows;
}

const ErrorRow& row_of(ErrorCode code) {
    return rows.at(static_cast<std::size_t>(code));
}

std::optional<ErrorCode> find_error_code(std::string_view name) {
    const auto* const row = std::ranges::find(rows, name, &ErrorRow::name);
    return row == rows.end() ? std::nullopt : std::optional(row->code);
}

ErrorCode general_code(ErrorKind kind) {
    return std::ranges::find(rows, kind, &ErrorRow::kind)->code;  // it is the first of its kind
}

ErrorCode code_of_system_error(int error) {
    const auto* const known = std::ranges::find(system_errors, error, [](const auto& row) { return row.first; });
    return known == system_errors.end() ? ErrorCode::io : known->second;
}

std::string text_of_system_error(int error) {
    return std::generic_category().message(error);
}

Error system_error(int error, const std::string& failed, std::string_view next) {
    return {code_of_system_error(error),
            fmt::format("{}: {}{}{}", failed, text_of_system_error(error), next.empty() ? "" : "; ", next)};
}

}  // namespace vvr
