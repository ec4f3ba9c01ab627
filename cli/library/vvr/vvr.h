#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vvr/vvr_c.h>

// The library for C++. All of it is in this header, made of the functions of vvr_c.h.
namespace vvr {

/// The category of an error, in the order of vvr_status.
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
    Failure(FailureKind kind, std::string code, const std::string& text)
        : std::runtime_error(text), kind_(kind), code_(std::move(code)) {}

    FailureKind kind() const noexcept {
        return kind_;
    }

    /// The exact error, such as "file-not-found". docs/reliability.md lists the codes; later versions may add some.
    const char* code() const noexcept {
        return code_.c_str();
    }

  private:
    FailureKind kind_;
    std::string code_;
};

/// The version of the loaded library, such as "0.1.0". It may be newer than the headers.
inline std::string library_version() {
    return vvr_version();
}

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
void write_image(const std::string& file, const Image& image);

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
ClipInfo read_clip_info(const std::string& clip);

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
    std::string kind;          ///< "moved", "stood", "left", "taken" or "changed"; later versions may add some
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
Rendering render_image(const std::string& clip, const Settings& settings = {}, const RenderOptions& options = {});

/// The same for frames in memory. Their values count as sRGB, full range. The picture's title is "frames in memory",
/// unless the settings have one.
/// \throws Failure usage also for frames that are not as described; not_video if there is none
Rendering render_image(const FrameSequence& frames, const Settings& settings = {}, const RenderOptions& options = {});

namespace detail {

struct FreeRendering {
    void operator()(vvr_rendering* rendering) const { vvr_free(rendering); }
};
using Owned = std::unique_ptr<vvr_rendering, FreeRendering>;

/// \throws Failure if the rendering has an error
inline Owned checked(Owned made) {
    if (!made) throw Failure(FailureKind::limit, "out-of-memory", "out of memory");
    if (made->status != VVR_OK) throw Failure(static_cast<FailureKind>(made->status - 1), made->code, made->text);
    return made;
}

inline std::vector<vvr_setting> views_of(const Settings& settings) {
    std::vector<vvr_setting> views;
    for (const auto& [name, value] : settings) views.push_back({name.c_str(), value.c_str()});
    return views;
}

/// The caller's functions, and what one of them threw: exceptions don't pass through C.
struct Callbacks {
    const RenderOptions& options;
    const FrameSequence* frames;
    std::mutex mutex{};  ///< the two may be called at the same time
    std::exception_ptr thrown{};

    /// \returns what `call` returns; 0 if it throws, or if a callback has thrown before
    template <class Call>
    int guard(const Call& call) noexcept {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            if (thrown) return 0;
        }
        try {
            return call() ? 1 : 0;
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex);
            thrown = std::current_exception();
            return 0;
        }
    }

    static int progress(void* self, int stage, std::int64_t done, std::int64_t total) {
        Callbacks& callbacks = *static_cast<Callbacks*>(self);
        const Progress now{stage == VVR_READING ? Progress::Stage::reading : Progress::Stage::drawing, done, total};
        return callbacks.guard([&] { return !callbacks.options.progress || callbacks.options.progress(now); });
    }

    static int read(void* self, std::int64_t index, vvr_frame* frame) {
        Callbacks& callbacks = *static_cast<Callbacks*>(self);
        return callbacks.guard([&] {
            FrameView view;
            if (!callbacks.frames->read(index, view)) return false;
            *frame = {view.pixels, view.stride, view.seconds};
            return true;
        });
    }
};

inline Event event_of(const vvr_event& found) {
    Event event{found.number,
                found.kind,
                found.object_class,
                found.score,
                found.first_frame,
                found.last_frame,
                found.first_seconds,
                found.last_seconds,
                found.still_seconds,
                found.direction,
                {found.x, found.y, found.width, found.height},
                {},
                found.from,
                found.into,
                found.by,
                found.open_ended != 0};
    for (std::size_t i = 0; i < found.path_length; ++i) {
        event.path.push_back({found.path[i].frame, found.path[i].seconds, found.path[i].x, found.path[i].y});
    }
    return event;
}

inline Rendering rendering_of(const vvr_rendering& made) {
    const auto pixels = static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height);
    const auto values = [&](const float* data, std::size_t per_pixel = 1) {
        return data == nullptr ? std::vector<float>() : std::vector<float>(data, data + per_pixel * pixels);
    };
    Rendering done;
    done.image = {made.width, made.height, values(made.rgba, 4), {}};
    for (std::size_t i = 0; i < made.setting_count; ++i) {
        done.image.settings.emplace_back(made.settings[i].name, made.settings[i].value);
    }
    done.frames = made.frames;
    done.damaged = made.damaged;
    done.warnings.assign(made.warnings, made.warnings + made.warning_count);
    for (std::size_t i = 0; i < made.event_count; ++i) done.events.push_back(event_of(made.events[i]));
    done.pixel_data = {values(made.depth), values(made.time), values(made.frame), values(made.object)};
    return done;
}

inline Rendering render(const std::string* clip, const FrameSequence* frames, const Settings& settings,
                        const RenderOptions& options) {
    Callbacks callbacks{options, frames};
    const std::vector<vvr_setting> views = views_of(settings);
    vvr_options chosen{views.data(), views.size(), options.events, options.pixel_data, nullptr, &callbacks};
    // Also if only the frames have a callback, so that its exception ends the render.
    if (options.progress || frames != nullptr) chosen.progress = Callbacks::progress;
    Owned rendering;
    if (clip != nullptr) {
        rendering.reset(vvr_render_clip(clip->c_str(), &chosen));
    } else {
        const vvr_frames sequence{frames->width,
                                  frames->height,
                                  static_cast<int>(frames->format),
                                  frames->frames_per_second,
                                  frames->frames,
                                  frames->read ? Callbacks::read : nullptr,
                                  &callbacks};
        rendering.reset(vvr_render_frames(&sequence, &chosen));
    }
    if (callbacks.thrown) std::rethrow_exception(callbacks.thrown);
    return rendering_of(*checked(std::move(rendering)));
}

}  // namespace detail

inline void write_image(const std::string& file, const Image& image) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width <= 0 || image.height <= 0 || image.rgba.size() != 4 * pixels) {
        throw Failure(FailureKind::usage, "usage",
                      "'" + file + "': an image of " + std::to_string(image.width) + "x" +
                          std::to_string(image.height) + " pixels needs 4 values per pixel, but has " +
                          std::to_string(image.rgba.size()) + " in total");
    }
    const std::vector<vvr_setting> views = detail::views_of(image.settings);
    vvr_rendering made{};
    made.width = image.width;
    made.height = image.height;
    made.rgba = image.rgba.data();
    made.settings = views.data();
    made.setting_count = views.size();
    detail::checked(detail::Owned(vvr_write_image(file.c_str(), &made)));
}

inline ClipInfo read_clip_info(const std::string& clip) {
    const detail::Owned made = detail::checked(detail::Owned(vvr_read_clip_info(clip.c_str())));
    const vvr_clip_info& info = made->clip;
    return {info.container, info.codec, info.width, info.height, info.frames_per_second, info.seconds, info.frames};
}

inline Rendering render_image(const std::string& clip, const Settings& settings, const RenderOptions& options) {
    return detail::render(&clip, nullptr, settings, options);
}

inline Rendering render_image(const FrameSequence& frames, const Settings& settings, const RenderOptions& options) {
    return detail::render(nullptr, &frames, settings, options);
}

}  // namespace vvr
