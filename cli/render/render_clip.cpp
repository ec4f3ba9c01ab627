#include "cli/render/render_clip.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <span>

#include "cli/render/annotate.h"
#include "cli/render/build_scene.h"
#include "cli/render/render_thread.h"
#include "core/events/event_finder.h"

namespace vvr {

namespace {

// Fewer frames are read in a few seconds: reading begins before OpenGL is known to work.
constexpr std::int64_t soon_read = 5000;
// With more frames the renderer is made after they have been read: memory counts for more than a moment then.
constexpr std::int64_t long_read = 100'000;

/// The volume of a clip, and the frames at its ends.
struct Fields {
    Volume volume;
    SharedFrame first = std::make_shared<const Frame>();
    SharedFrame last = first;
    std::vector<KeyFrame> keyframes{};
    FieldSummary summary{};
    std::optional<std::vector<Event>> events{};
};

Fields read_fields(const RenderJob& job, FieldSource& source, std::int64_t step, const FrameProgress& progress) {
    const std::int64_t expected = source.expected_frames();
    const FieldNeeds needs = needs_of(job, source, expected > 0 ? expected : step * job.max_layers);

    Fields result{Volume(source.field_size(), job.max_layers, step, needs.every)};
    std::optional<EventFinder> events;
    if (job.find_events) events.emplace(source.field_size());
    if (needs.flow) result.volume.keep_flow();
    result.summary = source.read(needs, [&](const SharedFrame& frame, const Field& field) {
        if (events) events->add(field.scalar, {field.index, field.pts});
        result.volume.add(field, volume_colour(job, *frame));
        if (result.volume.frames() == 1) result.first = frame;
        const std::int64_t number = result.volume.frames() - 1;
        const auto wanted = static_cast<std::int64_t>(result.keyframes.size()) + 1;
        if (expected > 0 && wanted <= job.keyframes && number == wanted * (expected - 1) / (job.keyframes + 1)) {
            result.keyframes.push_back({frame, number});
        }
        result.last = frame;
        if (progress) progress(result.volume.frames());
    });
    if (events) result.events = events->finish();
    return result;
}

std::vector<Brick> cut(const RenderJob& job, const Fields& fields) {
    const Volume& volume = fields.volume;
    // Where parts are left out, only the clock tells how long a brick is.
    if (job.brick_seconds > 0 && volume.left_out() > 0) {
        return cut_by_clock(volume, job.brick_seconds, static_cast<double>(job.clock.value_or(0)));
    }
    const double frames = static_cast<double>(volume.frames());
    double brick_frames = static_cast<double>(job.brick_frames);
    const double seconds = fields.last->pts - fields.first->pts;
    if (job.brick_seconds > 0 && seconds > 0) brick_frames = job.brick_seconds / seconds * (frames - 1);
    if (brick_frames <= 0) return cut_into(volume.layers(), job.bricks);
    const double layers = std::round(brick_frames / static_cast<double>(volume.step()));
    return cut_by(volume.layers(), std::max<std::int64_t>(1, static_cast<std::int64_t>(layers)));
}

/// All after the fields: draws each picture and gives it to the sink.
void draw_pictures(const RenderJob& job, Fields& fields, Drawing& drawing, RenderReport& report,
                   const PictureSink& sink) {
    const Volume& volume = fields.volume;
    const Layout& layout = *drawing.layout;
    report.events = std::move(fields.events);
    report.frames = fields.summary.frames;
    report.damaged = fields.summary.damaged;
    report.first_frame = fields.first->index;
    report.last_frame = fields.last->index;
    report.first_pts = fields.first->pts;
    report.last_pts = fields.last->pts;
    report.layers = volume.layers();
    report.step = volume.step();
    report.bricks = cut(job, fields);

    Scene scene = build_scene(job, volume, {*fields.first, *fields.last, fields.keyframes}, layout, drawing.framing);
    report.arrows = scene.arrows.size();
    report.keyframes = fields.keyframes.size();
    report.stages.end("scene");
    report.still = nothing_visible(volume, job.transfer);

    const std::vector<Brick> pieces =
        job.show.contains("volume") ? cut_into_pieces(report.bricks) : std::vector<Brick>{};
    const int textures = textures_of(job, static_cast<int>(pieces.size()));
    drawing.window = std::make_unique<BrickWindow>(drawing.context->gl(), layout, volume.layers(), textures);
    drawing.window->show(volume, pieces);
    add_overlays(job, drawing, report.bricks, volume.layers(), scene);
    drawing.renderer->set_scene(std::move(scene));
    report.lettering = letter(job, report, volume, layout, drawing.framing);
    for (int i = 0; i < job.pictures; ++i) {
        Picture picture = draw_picture(job, drawing, volume, report.lettering, static_cast<double>(i) / job.pictures);
        report.stages.end("draw");
        report.pictures = i + 1;
        sink(report, i, std::move(picture));
        report.stages.end("write");
    }
}

}  // namespace

const std::vector<std::string>& show_words() {
    static const std::vector<std::string> words = {"volume", "arrows", "tracelines", "outline", "frames", "floor",
                                                   "ruler",  "legend", "title",      "bricks",  "boxes",  "slices"};
    return words;
}

const std::vector<std::string>& standard_show() {
    static const std::vector<std::string> words = {"volume", "arrows", "outline", "frames",
                                                   "floor",  "ruler",  "legend",  "title"};
    return words;
}

std::int64_t planned_step(const RenderJob& job, std::int64_t frames) {
    if (job.step > 0) return job.step;
    return std::max<std::int64_t>(1, (frames + job.max_layers - 1) / job.max_layers);
}

int textures_of(const RenderJob& job, int pieces) {
    const bool drawn_again = job.series || job.pictures > 1;
    return std::max(1, drawn_again ? pieces : std::min(2, pieces));
}

RenderReport render_clip(const RenderJob& job, FieldSource& source, const FrameProgress& progress,
                         const PictureSink& sink) {
    const std::int64_t expected = source.expected_frames();
    const Size field_size = source.field_size();
    RenderThread thread;
    auto opened = thread.start([&job](Drawing& drawing) { open_context(job, drawing); });
    // The libraries take a second core's time to load, and the driver to compile shaders: meanwhile the clip is read.
    if (expected <= long_read) {
        thread.start([&job, field_size](Drawing& drawing) {
            make_renderer(job, field_size, RenderOptions{}.tile_samples, drawing);
            rehearse(job, drawing);
        });
    }
    if (expected == 0 || expected > soon_read) opened.get();
    std::int64_t step = planned_step(job, expected);
    Fields fields = read_fields(job, source, step, progress);
    // A header that promised far more than there was has wasted the window: read again, now knowing the length.
    if (job.step == 0 && step > 1 && fields.volume.layers() < job.max_layers / 2 && fields.volume.frames() > 1) {
        step = planned_step(job, fields.volume.frames());
        fields = read_fields(job, source, step, progress);
    }

    RenderReport report;
    report.stages.end("fields");
    thread.run([&](Drawing& drawing) {
        if (!drawing.renderer) make_renderer(job, field_size, RenderOptions{}.tile_samples / 4, drawing);
        describe(source, *drawing.context, report);
        draw_pictures(job, fields, drawing, report, sink);
    });
    return report;
}

}  // namespace vvr
