#include "cli/jobs/render_clip.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <span>

#include "cli/jobs/annotate.h"
#include "cli/jobs/build_scene.h"
#include "cli/jobs/drawing_ahead.h"
#include "core/events/event_finder.h"

namespace vvr {

namespace {

// So many frames are read in a few seconds: not worth waiting until it is known that they can be drawn.
constexpr std::int64_t soon_read = 5000;
// So many take longer than a hundred times what is won by being ready to draw when they have been read.
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
        if (events) events->add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts});
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
    if (events) result.events = choose_events(events->finish(result.summary.reference), job.events);
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

RenderedClip render_clip(const RenderJob& job, FieldSource& source, const FrameProgress& progress) {
    RenderedClip clip;
    clip.report = render_clip(job, source, progress, [&](const RenderReport&, int number, Picture&& picture) {
        if (number == 0) clip.picture = std::move(picture);
    });
    return clip;
}

RenderReport render_clip(const RenderJob& job, FieldSource& source, const FrameProgress& progress,
                         const PictureSink& sink) {
    RenderReport report;
    const std::int64_t expected = source.expected_frames();
    using Part = DrawingAhead::Part;
    DrawingAhead ahead(job, source.field_size(), expected > long_read ? Part::context : Part::all);
    if (expected == 0 || expected > soon_read) ahead.wait_for_context();
    std::int64_t step = planned_step(job, expected);
    Fields fields = read_fields(job, source, step, progress);
    // A header that promised far more than there was has wasted the window: read again, now knowing the length.
    if (job.step == 0 && step > 1 && fields.volume.layers() < job.max_layers / 2 && fields.volume.frames() > 1) {
        step = planned_step(job, fields.volume.frames());
        fields = read_fields(job, source, step, progress);
    }

    report.stages.end("fields");

    const Drawing drawing = ahead.take();
    const Layout& layout = *drawing.layout;
    const Framing& framing = drawing.framing;
    Renderer& renderer = *drawing.renderer;
    describe(source, *drawing.context, report);

    Volume& volume = fields.volume;
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

    Scene scene = build_scene(job, volume, {*fields.first, *fields.last, fields.keyframes}, layout, framing);
    report.arrows = scene.arrows.size();
    report.keyframes = fields.keyframes.size();

    report.stages.end("scene");

    report.still = nothing_visible(volume, job.transfer);

    const TransferFunction transfer = job.transfer.scaled(job.opacity);
    renderer.set_transfer(transfer);
    const std::vector<Brick> pieces =
        job.show.contains("volume") ? cut_into_pieces(report.bricks) : std::vector<Brick>{};
    renderer.show(volume, pieces, textures_of(job, static_cast<int>(pieces.size())));
    add_overlays(job, renderer, report.bricks, volume.layers(), layout, transfer, scene);
    renderer.set_scene(std::move(scene));
    report.lettering = letter(job, report, volume, layout, framing);
    for (int i = 0; i < job.pictures; ++i) {
        Picture picture = draw_picture(job, renderer, volume, report.lettering, static_cast<double>(i) / job.pictures);
        report.stages.end("draw");
        report.pictures = i + 1;
        sink(report, i, std::move(picture));
        report.stages.end("write");
    }
    return report;
}

}  // namespace vvr
