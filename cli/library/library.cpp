#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <vvr/vvr.h>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/app/render.h"
#include "cli/options/job_options.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/version.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/video/frame_source.h"

namespace vvr {

Failure::Failure(FailureKind kind, const char* code, const std::string& text)
    : std::runtime_error(text), kind_(kind), code_(code) {}

// Defined here, so that the library and its callers share one type for catch.
Failure::~Failure() = default;

namespace {

constexpr FailureKind failure_kind(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return FailureKind::usage;
        case ErrorKind::io:
            return FailureKind::io;
        case ErrorKind::not_video:
            return FailureKind::not_video;
        case ErrorKind::backend:
            return FailureKind::backend;
        case ErrorKind::limit:
            return FailureKind::limit;
        case ErrorKind::bug:
        case ErrorKind::partial:
        case ErrorKind::differs:
            break;  // only for commands that the library does not have
    }
    return FailureKind::bug;
}

/// Calls `action` and turns any exception into a Failure.
template <class Action>
auto as_failure(const Action& action) {
    try {
        return action();
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

static_assert(sizeof(image::Rgba) == 4 * sizeof(float), "a pixel is four floats, as an Image has them");

/// A drawn picture in the library's public type.
Image image_of(const image::Picture& picture, const image::Metadata& settings) {
    const auto values = std::as_bytes(picture.pixels.pixels());
    Image image{picture.pixels.width(), picture.pixels.height(), std::vector<float>(values.size() / sizeof(float)),
                settings};
    std::memcpy(image.rgba.data(), values.data(), values.size());
    return image;
}

/// Collects warnings.
class Warnings final : public app::Observer {
  public:
    void warn(const std::string& text, const RelatedSettings& /*about*/) override {
        const std::lock_guard lock(mutex_);
        texts_.push_back(text);
    }

    std::vector<std::string> take() { return std::move(texts_); }

  private:
    std::mutex mutex_;
    std::vector<std::string> texts_;
};

app::RenderJob job_of(const std::string& clip, const Settings& settings) {
    app::RenderJob job;
    options::CommandLine line("render", "");
    options::add_recording_options(line, job.input, "");
    options::add_picture_options(line, job);
    line.take({clip}, settings);
    app::require_input(job.input);
    options::finish(line, job, false);
    return job;
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

Rendering render_image(const std::string& clip, const Settings& settings) {
    return as_failure([&] {
        Warnings warnings;
        Rendering done;
        const app::RenderSummary report = app::render(
            job_of(clip, settings), warnings, [&done](const image::Picture& picture, const image::Metadata& record) {
                done.image = image_of(picture, record);
            });
        done.frames = report.frames;
        done.damaged = report.damaged;
        done.warnings = warnings.take();
        return done;
    });
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
