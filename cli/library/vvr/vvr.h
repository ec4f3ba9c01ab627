#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

/// The version of the loaded library, such as "0.1.0". It may be newer than the headers.
[[gnu::visibility("default")]] std::string library_version();

/// Names and values; the order is kept.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A picture in memory, with the settings that made it.
struct Image {
    int width = 0;            ///< pixels
    int height = 0;           ///< pixels
    std::vector<float> rgba;  ///< red, green, blue, alpha per pixel, 0..1, sRGB, premultiplied by alpha; 4·width·height
                              ///< values, rows from the top, no padding
    Settings settings;  ///< recorded in the file by write_image
};

/// Writes a picture with its settings. The file is replaced atomically. It contains no date, so equal images give equal
/// bytes.
/// \param file its extension sets the format: .png or another one of `vvr render -o`
/// \throws Failure usage for an unknown extension, or if the image does not have 4·width·height values; io
[[gnu::visibility("default")]] void write_image(const std::string& file, const Image& image);

/// Properties of a clip, from its container. Headers can be wrong: the numbers of frames and seconds are estimates.
struct ClipInfo {
    std::string container;         ///< short name of the format, for example "avi"
    std::string codec;             ///< short name of the codec, for example "h264"
    int width = 0;                 ///< pixels of a displayed frame, with square pixels
    int height = 0;                ///< pixels of a displayed frame, with square pixels
    double frames_per_second = 0;  ///< 0 = unknown
    double seconds = 0;            ///< 0 = unknown
    std::int64_t frames = 0;       ///< 0 = unknown
};

/// Opens a clip and decodes its first frame.
/// \param clip as INPUT of `vvr render`: a file, a URL, a folder or pattern of pictures
/// \throws Failure io when it can't be read, not_video when no frame decodes, limit
[[gnu::visibility("default")]] ClipInfo read_clip_info(const std::string& clip);

/// The result of a render.
struct Rendering {
    Image image;
    std::int64_t frames = 0;            ///< frames of the clip that the picture shows
    std::int64_t damaged = 0;           ///< packets skipped because they did not decode
    std::vector<std::string> warnings;  ///< about this picture, for people; UTF-8, one sentence each
};

/// Draws one picture of a whole clip, as `vvr render` does. Writes no file, prints nothing, and reads no config file.
/// It starts its own threads and uses OpenGL on one of them only, so the caller's context is unaffected. Calls must not
/// overlap.
/// \param clip as INPUT of `vvr render`: a file, a URL, a folder or pattern of pictures
/// \param settings options of `vvr render` in its groups Input to Look: long names without dashes, and values as text,
/// such as {{"size", "640x400"}, {"filter", "edges"}}; the last of equal names wins
/// \throws Failure usage for an unknown setting or an invalid value; io, not_video, backend, limit
[[gnu::visibility("default")]] Rendering render_image(const std::string& clip, const Settings& settings = {});

}  // namespace vvr
