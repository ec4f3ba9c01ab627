#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <vvr/vvr_c.h>

#include <fmt/format.h>

#include "cli/app/render.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/video_scale.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/version.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/media/frame_source.h"
#include "core/media/picture_source.h"
#include "core/tracking/event.h"
#include "core/tracking/event_line.h"

using vvr::Error;
using vvr::ErrorCode;
using vvr::ErrorKind;

namespace {

/// The first kinds are those of vvr_status, in its order; the others are of commands that the library does not have.
constexpr vvr_status status_of(ErrorKind kind) {
    return kind <= ErrorKind::limit ? static_cast<vvr_status>(static_cast<int>(kind) + 1) : VVR_BUG;
}
static_assert(status_of(ErrorKind::usage) == VVR_USAGE && status_of(ErrorKind::io) == VVR_IO);
static_assert(status_of(ErrorKind::not_video) == VVR_NOT_VIDEO && status_of(ErrorKind::backend) == VVR_BACKEND);
static_assert(status_of(ErrorKind::limit) == VVR_LIMIT);

/// A rendering, and what its pointers point to.
struct Made : vvr_rendering {
    vvr::image::Picture picture{};
    vvr::image::Metadata record{};
    vvr::app::RenderSummary summary{};
    std::string error{};
    std::vector<std::string> warning_texts{};
    std::vector<const char*> warning_views{};
    std::vector<vvr_setting> setting_views{};
    std::vector<std::vector<vvr_path_point>> paths{};
    std::vector<vvr_event> event_views{};
};

/// The caller's progress callback ended the render.
struct Cancelled {};

/// A rendering, made by `action`, with its error. Null only if there is no memory for it.
template <class Action>
vvr_rendering* make(const Action& action) {
    std::unique_ptr<Made> made(new (std::nothrow) Made{});
    if (made == nullptr) return nullptr;
    const auto fail = [&](vvr_status status, const char* code, std::string text) {
        made->status = status;
        made->code = code;
        made->error = std::move(text);
    };
    made->code = "";
    try {
        action(*made);
    } catch (const Cancelled&) {
        fail(VVR_CANCELLED, "cancelled", "the progress callback ended the render");
    } catch (const Error& error) {
        fail(status_of(error.kind()), vvr::row_of(error.code()).name, error.what());
    } catch (const std::exception& error) {
        if (vvr::is_out_of_memory(error)) {
            fail(VVR_LIMIT, "out-of-memory", "out of memory; try a smaller field-size, size or window");
        } else {
            fail(VVR_BUG, "bug", std::string("this is a bug in vvr, please report it: ") + error.what());
        }
    } catch (...) {  // of a callback in C++
        fail(VVR_USAGE, "usage", "a callback has thrown an exception; return 0 from it instead");
    }
    made->text = made->error.c_str();
    return made.release();  // the caller owns it: vvr_free
}

void require(const void* pointer, const char* what) {
    if (pointer == nullptr) throw Error(ErrorCode::usage, fmt::format("no {} given: the pointer is NULL", what));
}

std::vector<std::pair<std::string, std::string>> pairs_of(const vvr_setting* settings, std::size_t count) {
    if (count > 0) require(settings, "array of settings");
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const vvr_setting& one : std::span(settings, count)) {
        if (one.name == nullptr || one.value == nullptr) require(nullptr, "name or value of a setting");
        pairs.emplace_back(one.name, one.value);
    }
    return pairs;
}

/// Collects warnings, and passes the progress on.
class LibraryObserver final : public vvr::app::Observer {
  public:
    explicit LibraryObserver(const vvr_options& options) : options_(options) {}

    void frames(std::int64_t done, std::int64_t expected) override { tell(VVR_READING, done, expected); }

    void drawing(std::int64_t done, std::int64_t parts) override { tell(VVR_DRAWING, done, parts); }

    void warn(const std::string& text, const vvr::RelatedSettings& /*about*/) override {
        const std::lock_guard lock(mutex_);
        warnings_.push_back(text);
    }

    std::vector<std::string> take_warnings() { return std::move(warnings_); }

  private:
    void tell(vvr_stage stage, std::int64_t done, std::int64_t total) {
        if (options_.progress == nullptr) return;
        if (options_.progress(options_.user, stage, done, total) == 0) throw Cancelled();
    }

    const vvr_options& options_;
    std::mutex mutex_;
    std::vector<std::string> warnings_;
};

void list_events(Made& made) {
    const vvr::app::ShownEvents& shown = made.summary.events;
    if (shown.events.empty()) return;
    const vvr::app::VideoScale scale(made.summary.field_size, made.summary.info.size);
    const auto number_of = [&](const std::optional<std::size_t>& place) {
        return place ? static_cast<int>(shown.numbers[*place]) : 0;
    };
    for (const vvr::tracking::Event& found : shown.events) {
        auto& path = made.paths.emplace_back();
        for (const vvr::tracking::PathPoint& point : found.path) {
            const glm::dvec2 place = scale(point.place);
            path.push_back({point.at.frame, point.at.seconds, place.x, place.y});
        }
    }
    for (std::size_t k = 0; k < shown.events.size(); ++k) {
        const vvr::tracking::Event& found = shown.events[k];
        const vvr::PixelBox box = scale(found.box);
        vvr_event event{};
        event.number = static_cast<int>(shown.numbers[k]);
        event.kind = vvr::tracking::name_of(found.kind).data();
        event.object_class = found.identity ? found.identity->what->name.data() : "";
        event.score = found.identity ? found.identity->score : 0;
        event.first_frame = found.first.frame;
        event.last_frame = found.last.frame;
        event.first_seconds = found.first.seconds;
        event.last_seconds = found.last.seconds;
        event.still_seconds = vvr::tracking::stationary_seconds(found);
        event.direction = vvr::tracking::direction_of(found).data();
        event.x = box.left;
        event.y = box.top;
        event.width = box.width();
        event.height = box.height();
        event.from = number_of(found.from);
        event.into = number_of(found.into);
        event.by = number_of(found.by);
        event.open_ended = found.open_ended ? 1 : 0;
        event.path = made.paths[k].data();
        event.path_length = made.paths[k].size();
        made.event_views.push_back(event);
    }
}

constexpr const char* name_of_frames = "frames in memory";

vvr::media::PixelOrder order_of(int format) {
    using vvr::media::PixelOrder;
    constexpr std::array orders{PixelOrder::grey, PixelOrder::rgb, PixelOrder::bgr, PixelOrder::rgba, PixelOrder::bgra};
    if (format >= 0 && static_cast<std::size_t>(format) < orders.size())
        return orders[static_cast<std::size_t>(format)];
    throw Error(ErrorCode::input_unsuitable,
                fmt::format("there is no pixel format {}; choose one of PixelFormat", format));
}

/// An input that opens the caller's frames instead of a file.
/// \param frames must outlive what the input opens
vvr::app::InputOptions input_of(const vvr_frames& frames) {
    vvr::app::InputOptions input;
    input.names = {name_of_frames};
    input.open = [&frames](const vvr::media::SourceOptions& options) {
        vvr::media::MemoryFrames memory{.name = name_of_frames,
                                        .size = {frames.width, frames.height},
                                        .order = order_of(frames.format),
                                        .rate = frames.frames_per_second,
                                        .frames = frames.frames,
                                        .read = {}};
        if (frames.read != nullptr) {
            memory.read = [&frames](std::int64_t index, vvr::media::MemoryFrame& frame) {
                vvr_frame view{};
                if (frames.read(frames.user, index, &view) == 0) return false;
                frame = {view.pixels, view.stride, view.seconds};
                return true;
            };
        }
        return std::make_unique<vvr::media::MemorySource>(std::move(memory), options);
    };
    return input;
}

void render(Made& made, vvr::app::InputOptions input, const vvr_options* options) {
    const vvr_options none{};
    const vvr_options& chosen = options == nullptr ? none : *options;
    vvr::app::RenderJob job;
    job.input = std::move(input);
    vvr::options::CommandLine line("render", "");
    vvr::options::add_recording_options(line, job.input, "");
    vvr::options::add_picture_options(line, job);
    line.take(job.input.names, pairs_of(chosen.settings, chosen.setting_count));
    vvr::app::require_input(job.input);
    vvr::options::finish(line, job, false);
    job.output.returns_events = chosen.events != 0;
    job.output.returns_pixel_data = chosen.pixel_data != 0;
    LibraryObserver observer(chosen);
    made.summary = vvr::app::render(job, observer, [&](const auto& picture, const auto& record) {
        made.picture = picture;
        made.record = record;
    });
    list_events(made);
    made.warning_texts = observer.take_warnings();
}

/// Sets the pointers of a rendering to what was made.
void show(Made& made) {
    const auto data = [](const vvr::Plane<float>& plane) {
        return plane.pixels().empty() ? nullptr : plane.pixels().data();
    };
    const auto& pixels = made.picture.pixels;
    made.width = pixels.width();
    made.height = pixels.height();
    made.rgba = pixels.pixels().empty() ? nullptr : &pixels.pixels().front().r;
    made.depth = data(made.picture.pixel_data.depth);
    made.time = data(made.picture.pixel_data.time);
    made.frame = data(made.picture.pixel_data.frame);
    made.object = data(made.picture.pixel_data.object);
    made.frames = made.summary.frames;
    made.damaged = made.summary.damaged;
    for (const auto& [name, value] : made.record) made.setting_views.push_back({name.c_str(), value.c_str()});
    for (const std::string& text : made.warning_texts) made.warning_views.push_back(text.c_str());
    made.settings = made.setting_views.data();
    made.setting_count = made.setting_views.size();
    made.warnings = made.warning_views.data();
    made.warning_count = made.warning_views.size();
    made.events = made.event_views.data();
    made.event_count = made.event_views.size();
}

static_assert(sizeof(vvr::image::Rgba) == 4 * sizeof(float), "a pixel is four floats, as vvr_rendering has them");

}  // namespace

vvr_rendering* vvr_render_clip(const char* clip, const vvr_options* options) {
    return make([&](Made& made) {
        require(clip, "clip");
        vvr::app::InputOptions input;
        input.names = {clip};
        render(made, std::move(input), options);
        show(made);
    });
}

vvr_rendering* vvr_render_frames(const vvr_frames* frames, const vvr_options* options) {
    return make([&](Made& made) {
        require(frames, "frames");
        render(made, input_of(*frames), options);
        show(made);
    });
}

vvr_rendering* vvr_read_clip_info(const char* clip) {
    return make([&](Made& made) {
        require(clip, "clip");
        vvr::app::InputOptions input;
        input.names = {clip};
        vvr::app::require_input(input);
        std::vector<std::string> warnings;
        made.summary.info = vvr::app::open_clip(input, false, 0, warnings)->info();
        const vvr::media::VideoInfo& info = made.summary.info;
        made.clip = {info.container.c_str(), info.codec.c_str(), info.size.width, info.size.height, info.rate,
                     info.duration,          info.frames};
    });
}

vvr_rendering* vvr_write_image(const char* file, const vvr_rendering* image) {
    return make([&](Made&) {
        require(file, "file");
        require(image, "image");
        require(image->rgba, "image");
        if (image->width <= 0 || image->height <= 0)
            throw Error(ErrorCode::usage,
                        fmt::format("'{}': there is no image of {}x{} pixels", file, image->width, image->height));
        auto pixels = vvr::Plane<vvr::image::Rgba>::for_overwrite({image->width, image->height});
        std::memcpy(std::as_writable_bytes(pixels.pixels()).data(), image->rgba, pixels.pixels().size_bytes());
        vvr::image::write_picture(file, {std::move(pixels)}, pairs_of(image->settings, image->setting_count));
    });
}

void vvr_free(vvr_rendering* rendering) {
    const std::unique_ptr<Made> owned(static_cast<Made*>(rendering));
}

const char* vvr_version() {
    static const std::string version(vvr::version());
    return version.c_str();
}
