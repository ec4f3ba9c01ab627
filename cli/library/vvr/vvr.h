#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
    cancelled,  ///< the caller's progress callback ended the render
};

/// The only exception that this library throws, besides those of the caller's own callbacks. what() is UTF-8. It names
/// the file or setting, what was found, and the next step.
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

/// The channels of a pixel in memory, in this order, 8 bits each. Alpha is ignored.
enum class PixelFormat { gray, rgb, bgr, rgba, bgra };

/// A frame in the caller's memory.
struct FrameView {
    const std::uint8_t* pixels = nullptr;  ///< the top row
    std::ptrdiff_t stride = 0;  ///< bytes from a row to the one below it; negative if the bottom row is first
    double seconds = 0;         ///< greater than that of the frame before
};

/// A clip whose frames come from the caller.
struct FrameSequence {
    int width = 0;   ///< pixels of each frame
    int height = 0;  ///< pixels of each frame
    PixelFormat format = PixelFormat::bgr;
    double frames_per_second = 0;  ///< 0 = unknown
    std::int64_t frames = 0;       ///< 0 = unknown; with it, layers are as long as those of a file with this clip

    /// Reads frame `index`; returns false after the last one. The indices are consecutive. A clip is read more than
    /// once, and each pass begins with 0 again. It is called from threads of the library, from one at a time. The
    /// frame's memory must not change until the next call.
    std::function<bool(std::int64_t index, FrameView& frame)> read;
};

/// How far a render has come.
struct Progress {
    enum class Stage { reading, drawing };
    Stage stage = Stage::reading;
    std::int64_t done = 0;   ///< frames read; or equal parts of the picture drawn
    std::int64_t total = 0;  ///< 0 = unknown
};

/// What a render does besides the picture.
struct RenderOptions {
    bool events = false;      ///< return the events; they need a filter that finds objects, as the default one does
    bool pixel_data = false;  ///< return what each pixel shows

    /// Called often while frames are read and while the picture is drawn, from threads of the library, from one at a
    /// time. If it returns false, the render ends with a Failure, cancelled.
    std::function<bool(const Progress&)> progress;
};

/// What each pixel of a picture shows: width · height values each, rows from the top. Empty unless requested.
struct PixelData {
    std::vector<float> depth;  ///< from the eye along the view direction, units of the scene; NaN = nothing visible
    std::vector<float> time;   ///< seconds of the clip; NaN = none
    std::vector<float> frame;  ///< index in the clip; -1 = none
    std::vector<float>
        object;  ///< number of the event; 0 = none. Empty if the picture's colours aren't those of objects
};

/// A box of pixels of a displayed frame.
struct Box {
    int x = 0;  ///< of the leftmost pixel
    int y = 0;  ///< of the topmost pixel
    int width = 0;
    int height = 0;
};

/// A place of an object.
struct PathPoint {
    std::int64_t frame = 0;
    double seconds = 0;
    double x = 0;  ///< pixels of a displayed frame; the centre of the first pixel is 0
    double y = 0;
};

/// An object of the clip, from its first to its last frame.
struct Event {
    int number = 0;            ///< from 1; the picture shows it
    std::string kind;          ///< "moved", "stood", "left" or "taken"; later versions may add some
    std::string object_class;  ///< such as "person"; empty without a detector
    double score = 0;          ///< of the class, 0..1
    std::int64_t first_frame = 0;
    std::int64_t last_frame = 0;
    double first_seconds = 0;
    double last_seconds = 0;
    double still_seconds = 0;  ///< in which it kept its place
    std::string direction;     ///< such as "right"; empty where it isn't known
    Box box;                   ///< of all its places
    std::vector<PathPoint> path;
    int from = 0;             ///< number of the event from which it split; 0 = none
    int into = 0;             ///< number of the event in which it merged; 0 = none
    int by = 0;               ///< number of the event that put it down or took it; 0 = none
    bool open_ended = false;  ///< it was there until a gap or the end of the clip: `last_frame` is not when it went
};

/// The result of a render.
struct Rendering {
    Image image;
    std::int64_t frames = 0;            ///< frames of the clip that the picture shows
    std::int64_t damaged = 0;           ///< packets skipped because they did not decode
    std::vector<std::string> warnings;  ///< about this picture, for people; UTF-8, one sentence each
    std::vector<Event> events;          ///< by their first frames; empty unless requested
    PixelData pixel_data;               ///< of the image's size; empty unless requested
};

/// Draws one picture of a whole clip, as `vvr render` does. Writes no file, prints nothing, and reads no config file.
/// It starts its own threads and uses OpenGL on one of them only, so the caller's context is unaffected. Several
/// threads may call it at the same time.
/// \param clip as INPUT of `vvr render`: a file, a URL, a folder or pattern of pictures
/// \param settings options of `vvr render` in its groups Input to Look: long names without dashes, and values as text,
/// such as {{"size", "640x400"}, {"filter", "edges"}}; the last of equal names wins
/// \throws Failure usage for an unknown setting or an invalid value; io, not_video, backend, limit, cancelled; and
/// whatever a callback throws
[[gnu::visibility("default")]] Rendering render_image(const std::string& clip, const Settings& settings = {},
                                                      const RenderOptions& options = {});

/// The same for frames in memory. Their values count as sRGB, full range. The picture's title is "frames in memory",
/// unless the settings have one.
/// \throws Failure usage also for frames that are not as described; not_video if there is none
[[gnu::visibility("default")]] Rendering render_image(const FrameSequence& frames, const Settings& settings = {},
                                                      const RenderOptions& options = {});

}  // namespace vvr
