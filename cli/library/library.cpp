#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <vvr/vvr.h>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/app/render.h"
#include "cli/app/video_scale.h"
#include "cli/options/job_options.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/version.h"
#include "core/events/event.h"
#include "core/events/event_line.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/video/frame_source.h"
#include "core/video/memory_source.h"

namespace vvr {

Failure::Failure(FailureKind kind, const char* code, const std::string& text)
    : std::runtime_error(text), kind_(kind), code_(code) {}

// Defined here, so that the library and its callers share one type for catch.
Failure::~Failure() = default;

namespace {

/// The first kinds are those of a FailureKind, in its order; the others are of commands that the library does not have.
constexpr FailureKind failure_kind(ErrorKind kind) {
    return kind <= ErrorKind::limit ? static_cast<FailureKind>(kind) : FailureKind::bug;
}
static_assert(failure_kind(ErrorKind::usage) == FailureKind::usage && failure_kind(ErrorKind::io) == FailureKind::io);
static_assert(failure_kind(ErrorKind::not_video) == FailureKind::not_video);
static_assert(failure_kind(ErrorKind::backend) == FailureKind::backend);
static_assert(failure_kind(ErrorKind::limit) == FailureKind::limit);

/// What a callback of the caller threw.
struct CallbackError {
    std::exception_ptr error;
};

/// The caller's progress callback ended the render.
struct Cancelled {};

/// Calls `action` and turns any exception into a Failure, except that of a callback.
template <class Action>
auto as_failure(const Action& action) {
    try {
        return action();
    } catch (const CallbackError& callback) {
        std::rethrow_exception(callback.error);
    } catch (const Cancelled&) {
        throw Failure(FailureKind::cancelled, "cancelled", "the progress callback ended the render");
    } catch (const Error& error) {
        throw Failure(failure_kind(error.kind()), row_of(error.code()).name, error.what());
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) {
            throw Failure(FailureKind::limit, row_of(ErrorCode::out_of_memory).name,
                          "out of memory; try a smaller field-size, size or window");
        }
        throw Failure(FailureKind::bug, row_of(ErrorCode::bug).name,
                      std::string("this is a bug in vvr, please report it: ") + error.what());
    }
}

/// Calls a callback of the caller, and marks what it throws.
template <class Callback, class... Arguments>
bool call(const Callback& callback, Arguments&&... arguments) {
    try {
        return callback(std::forward<Arguments>(arguments)...);
    } catch (...) {
        throw CallbackError{std::current_exception()};
    }
}

static_assert(sizeof(image::Rgba) == 4 * sizeof(float), "a pixel is four floats, as an Image has them");

/// A drawn picture in the library's public type.
Image image_of(const image::Picture& picture, const image::Metadata& settings) {
    const auto values = std::as_bytes(picture.pixels.pixels());
    Image image{picture.pixels.width(), picture.pixels.height(), std::vector<float>(values.size() / sizeof(float)),
                settings};
    std::memcpy(image.rgba.data(), values.data(), values.size());
    return image;
}

/// Collects warnings, and passes the progress on.
class LibraryObserver final : public app::Observer {
  public:
    explicit LibraryObserver(const std::function<bool(const Progress&)>& progress) : progress_(progress) {}

    void frames(std::int64_t done, std::int64_t expected) override { tell({Progress::Stage::reading, done, expected}); }

    void drawing(std::int64_t done, std::int64_t parts) override { tell({Progress::Stage::drawing, done, parts}); }

    void warn(const std::string& text, const RelatedSettings& /*about*/) override {
        const std::lock_guard lock(mutex_);
        warnings_.push_back(text);
    }

    std::vector<std::string> take_warnings() { return std::move(warnings_); }

  private:
    void tell(const Progress& progress) {
        if (progress_ && !call(progress_, progress)) throw Cancelled();
    }

    const std::function<bool(const Progress&)>& progress_;
    std::mutex mutex_;
    std::vector<std::string> warnings_;
};

PixelData pixel_data_of(const image::PixelData& data) {
    const auto values = [](const Plane<float>& plane) {
        return std::vector<float>(plane.pixels().begin(), plane.pixels().end());
    };
    return {values(data.depth), values(data.time), values(data.frame), values(data.object)};
}

std::vector<Event> events_of(const app::RenderSummary& summary) {
    std::vector<Event> events;
    if (summary.events.events.empty()) return events;
    const app::VideoScale scale(summary.field_size, summary.info.size);
    const auto number_of = [&](const std::optional<std::size_t>& place) {
        return place ? static_cast<int>(summary.events.numbers[*place]) : 0;
    };
    for (std::size_t k = 0; k < summary.events.events.size(); ++k) {
        const events::Event& found = summary.events.events[k];
        const PixelBox box = scale(found.box);
        Event event;
        event.number = static_cast<int>(summary.events.numbers[k]);
        event.kind = events::name_of(found.kind);
        if (found.identity) {
            event.object_class = found.identity->what->name;
            event.score = found.identity->score;
        }
        event.first_frame = found.first.frame;
        event.last_frame = found.last.frame;
        event.first_seconds = found.first.seconds;
        event.last_seconds = found.last.seconds;
        event.open_ended = found.open_ended;
        event.still_seconds = events::stationary_seconds(found);
        event.direction = events::direction_of(found);
        event.box = {box.left, box.top, box.width(), box.height()};
        for (const events::PathPoint& point : found.path) {
            const glm::dvec2 place = scale(point.place);
            event.path.push_back({point.at.frame, point.at.seconds, place.x, place.y});
        }
        event.from = number_of(found.from);
        event.into = number_of(found.into);
        event.by = number_of(found.by);
        events.push_back(std::move(event));
    }
    return events;
}

constexpr video::PixelOrder order_of(PixelFormat format) {
    switch (format) {
        case PixelFormat::gray:
            return video::PixelOrder::grey;
        case PixelFormat::rgb:
            return video::PixelOrder::rgb;
        case PixelFormat::bgr:
            return video::PixelOrder::bgr;
        case PixelFormat::rgba:
            return video::PixelOrder::rgba;
        case PixelFormat::bgra:
            return video::PixelOrder::bgra;
    }
    throw Error(ErrorCode::input_unsuitable,
                fmt::format("there is no pixel format {}; choose one of PixelFormat", static_cast<int>(format)));
}

constexpr const char* name_of_frames = "frames in memory";

/// An input that opens the caller's frames instead of a file.
/// \param frames must outlive what the input opens
app::InputOptions input_of(const FrameSequence& frames) {
    app::InputOptions input;
    input.names = {name_of_frames};
    input.open = [&frames](const video::SourceOptions& options) {
        video::MemoryFrames memory{.name = name_of_frames,
                                   .size = {frames.width, frames.height},
                                   .order = order_of(frames.format),
                                   .rate = frames.frames_per_second,
                                   .frames = frames.frames,
                                   .read = {}};
        if (frames.read) {
            memory.read = [&frames](std::int64_t index, video::MemoryFrame& frame) {
                FrameView view;
                if (!call(frames.read, index, view)) return false;
                frame = {view.pixels, view.stride, view.seconds};
                return true;
            };
        }
        return std::make_unique<video::MemorySource>(std::move(memory), options);
    };
    return input;
}

Rendering render(app::InputOptions input, const Settings& settings, const RenderOptions& options) {
    return as_failure([&] {
        app::RenderJob job;
        job.input = std::move(input);
        options::CommandLine line("render", "");
        options::add_recording_options(line, job.input, "");
        options::add_picture_options(line, job);
        line.take(job.input.names, settings);
        app::require_input(job.input);
        options::finish(line, job, false);
        job.output.returns_events = options.events;
        job.output.returns_pixel_data = options.pixel_data;
        LibraryObserver observer(options.progress);
        Rendering done;
        const app::RenderSummary summary =
            app::render(job, observer, [&](const image::Picture& picture, const image::Metadata& record) {
                done.image = image_of(picture, record);
                done.pixel_data = pixel_data_of(picture.pixel_data);
            });
        done.frames = summary.frames;
        done.damaged = summary.damaged;
        done.events = events_of(summary);
        done.warnings = observer.take_warnings();
        return done;
    });
}

}  // namespace

std::string library_version() {
    return std::string(version());
}

ClipInfo read_clip_info(const std::string& clip) {
    return as_failure([&] {
        app::InputOptions input;
        input.names = {clip};
        app::require_input(input);
        std::vector<std::string> warnings;
        const std::unique_ptr<video::FrameSource> source = app::open_clip(input, false, 0, warnings);
        const video::VideoInfo& info = source->info();
        return ClipInfo{info.container, info.codec,    info.size.width, info.size.height,
                        info.rate,      info.duration, info.frames};
    });
}

Rendering render_image(const std::string& clip, const Settings& settings, const RenderOptions& options) {
    app::InputOptions input;
    input.names = {clip};
    return render(std::move(input), settings, options);
}

Rendering render_image(const FrameSequence& frames, const Settings& settings, const RenderOptions& options) {
    return render(input_of(frames), settings, options);
}

void write_image(const std::string& file, const Image& image) {
    as_failure([&] {
        const bool sized = image.width > 0 && image.height > 0;
        const std::size_t values =
            sized ? std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) : 0;
        if (!sized || image.rgba.size() != values) {
            throw Error(ErrorCode::usage,
                        fmt::format("'{}': an image of {}x{} pixels needs 4 values per pixel, but has {} in total",
                                    file, image.width, image.height, image.rgba.size()));
        }
        auto pixels = Plane<image::Rgba>::for_overwrite({image.width, image.height});
        std::memcpy(std::as_writable_bytes(pixels.pixels()).data(), image.rgba.data(), values * sizeof(float));
        image::write_picture(file, {std::move(pixels)}, image.settings);
    });
}

}  // namespace vvr
