#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <vvr/vvr.h>
#include <vvr/vvr_c.h>

// The functions for C: each calls one of vvr.h and keeps its error.

/// The result of a render, or its error.
struct vvr_rendering {
    vvr::Rendering result{};
    std::vector<vvr_event> events{};  ///< with pointers into `result`
    vvr_status status = VVR_OK;
    const char* code = "";
    std::string text{};
};

namespace {

using vvr::FailureKind;

/// The kinds follow VVR_OK in their own order.
constexpr vvr_status status_of(FailureKind kind) {
    return static_cast<vvr_status>(static_cast<int>(kind) + 1);
}
static_assert(status_of(FailureKind::usage) == VVR_USAGE && status_of(FailureKind::limit) == VVR_LIMIT);
static_assert(status_of(FailureKind::bug) == VVR_BUG && status_of(FailureKind::cancelled) == VVR_CANCELLED);

vvr_event event_of(const vvr::Event& event) {
    return {event.number,
            event.kind.c_str(),
            event.object_class.c_str(),
            event.score,
            event.first_frame,
            event.last_frame,
            event.first_seconds,
            event.last_seconds,
            event.still_seconds,
            event.direction.c_str(),
            event.box.x,
            event.box.y,
            event.box.width,
            event.box.height,
            event.from,
            event.into,
            event.by,
            event.open_ended ? 1 : 0};
}

/// Calls `action`, and keeps its error in the rendering.
template <class Action>
int keep_error(vvr_rendering& rendering, const Action& action) {
    rendering.status = VVR_OK;
    rendering.code = "";
    rendering.text.clear();
    try {
        action();
    } catch (const vvr::Failure& failure) {
        rendering.status = status_of(failure.kind());
        rendering.code = failure.code();
        rendering.text = failure.what();
    } catch (const std::bad_alloc&) {
        rendering.status = VVR_LIMIT;
        rendering.code = "out-of-memory";
        rendering.text = "out of memory";  // short enough to need none
    } catch (...) {                        // of a callback in C++, which C could not see
        rendering.status = VVR_USAGE;
        rendering.code = "usage";
        rendering.text = "a callback has thrown an exception; return 0 from it instead";
    }
    return rendering.status;
}

vvr::Failure missing(const char* what) {
    return {FailureKind::usage, "usage", std::string("no ") + what + " given: the pointer is NULL"};
}

vvr::Settings settings_of(const vvr_options& options) {
    vvr::Settings settings;
    if (options.settings == nullptr && options.setting_count > 0) throw missing("array of settings");
    for (std::size_t i = 0; i < options.setting_count; ++i) {
        const vvr_setting& one = options.settings[i];
        if (one.name == nullptr || one.value == nullptr) throw missing("name or value of a setting");
        settings.emplace_back(one.name, one.value);
    }
    return settings;
}

vvr::RenderOptions options_of(const vvr_options& options) {
    vvr::RenderOptions made;
    made.events = options.events != 0;
    made.pixel_data = options.pixel_data != 0;
    if (options.progress != nullptr) {
        made.progress = [&options](const vvr::Progress& progress) {
            const int stage = progress.stage == vvr::Progress::Stage::reading ? VVR_READING : VVR_DRAWING;
            return options.progress(options.user, stage, progress.done, progress.total) != 0;
        };
    }
    return made;
}

vvr::FrameSequence frames_of(const vvr_frames& frames) {
    vvr::FrameSequence made;
    made.width = frames.width;
    made.height = frames.height;
    made.format = static_cast<vvr::PixelFormat>(frames.format);
    made.frames_per_second = frames.frames_per_second;
    made.frames = frames.frames;
    if (frames.read != nullptr) {
        made.read = [&frames](std::int64_t index, vvr::FrameView& view) {
            vvr_frame frame{};
            if (frames.read(frames.user, index, &frame) == 0) return false;
            view = {frame.pixels, frame.stride, frame.seconds};
            return true;
        };
    }
    return made;
}

/// \param draw called with settings and options
template <class Draw>
vvr_rendering* render(const vvr_options* options, const Draw& draw) {
    std::unique_ptr<vvr_rendering> rendering(new (std::nothrow) vvr_rendering);
    if (rendering == nullptr) return nullptr;
    const vvr_options none{};
    const vvr_options& chosen = options == nullptr ? none : *options;
    keep_error(*rendering, [&] {
        rendering->result = draw(settings_of(chosen), options_of(chosen));
        for (const vvr::Event& event : rendering->result.events) rendering->events.push_back(event_of(event));
    });
    return rendering.release();  // the caller owns it: vvr_free
}

}  // namespace

vvr_rendering* vvr_render_clip(const char* clip, const vvr_options* options) {
    return render(options, [&](const vvr::Settings& settings, const vvr::RenderOptions& chosen) {
        if (clip == nullptr) throw missing("clip");
        return vvr::render_image(clip, settings, chosen);
    });
}

vvr_rendering* vvr_render_frames(const vvr_frames* frames, const vvr_options* options) {
    return render(options, [&](const vvr::Settings& settings, const vvr::RenderOptions& chosen) {
        if (frames == nullptr) throw missing("frames");
        return vvr::render_image(frames_of(*frames), settings, chosen);
    });
}

void vvr_free(vvr_rendering* rendering) {
    const std::unique_ptr<vvr_rendering> owned(rendering);
}

int vvr_status_of(const vvr_rendering* rendering) {
    return rendering == nullptr ? VVR_LIMIT : rendering->status;
}

const char* vvr_error_code(const vvr_rendering* rendering) {
    return rendering == nullptr ? "out-of-memory" : rendering->code;
}

const char* vvr_error_text(const vvr_rendering* rendering) {
    return rendering == nullptr ? "out of memory" : rendering->text.c_str();
}

const float* vvr_image(const vvr_rendering* rendering, int* width, int* height) {
    const vvr::Image& image = rendering->result.image;
    if (width != nullptr) *width = image.width;
    if (height != nullptr) *height = image.height;
    return image.rgba.empty() ? nullptr : image.rgba.data();
}

const float* vvr_pixel_data(const vvr_rendering* rendering, const char* name) {
    const vvr::PixelData& data = rendering->result.pixel_data;
    struct Row {
        std::string_view name;
        const std::vector<float>& values;
    };
    for (const Row& row :
         {Row{"depth", data.depth}, Row{"time", data.time}, Row{"frame", data.frame}, Row{"object", data.object}}) {
        if (name != nullptr && row.name == name) return row.values.empty() ? nullptr : row.values.data();
    }
    return nullptr;
}

std::int64_t vvr_frame_count(const vvr_rendering* rendering) {
    return rendering->result.frames;
}

std::size_t vvr_warning_count(const vvr_rendering* rendering) {
    return rendering->result.warnings.size();
}

const char* vvr_warning(const vvr_rendering* rendering, std::size_t index) {
    const std::vector<std::string>& warnings = rendering->result.warnings;
    return index < warnings.size() ? warnings[index].c_str() : nullptr;
}

std::size_t vvr_event_count(const vvr_rendering* rendering) {
    return rendering->events.size();
}

const vvr_event* vvr_event_at(const vvr_rendering* rendering, std::size_t index) {
    return index < rendering->events.size() ? &rendering->events[index] : nullptr;
}

int vvr_write_image(vvr_rendering* rendering, const char* file) {
    return keep_error(*rendering, [&] {
        if (file == nullptr) throw missing("file");
        vvr::write_image(file, rendering->result.image);
    });
}

const char* vvr_version() {
    static const std::string version = vvr::library_version();
    return version.c_str();
}
