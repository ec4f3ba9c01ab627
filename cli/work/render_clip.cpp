#include "cli/work/render_clip.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/events/event_finder.h"
#include "core/scene/overlay.h"
#include "gl/context.h"

namespace vvr {

namespace {

// Arrows at so many times along the arc leave each other room.
constexpr std::int64_t arrow_times = 80;

/// The volume of a clip, and the frames at its ends.
struct Fields {
    Volume volume;
    Frame first;
    Frame last;
    FieldSummary summary;
    std::optional<std::vector<Event>> events;
};

Fields read_fields(const RenderJob& job, FieldSource& source, std::int64_t step, const FrameProgress& progress) {
    const std::int64_t expected = source.expected_frames();
    const std::int64_t every = expected > 0 ? expected / arrow_times : step * job.max_layers / arrow_times;
    FieldNeeds needs;
    needs.flow = job.show.contains("tracelines");
    needs.seeds = needs.flow || job.show.contains("arrows");
    needs.colour = job.picture.colour == VolumeColour::video;
    needs.every = source.interval(std::max<std::int64_t>(1, every));

    Fields result{Volume(source.field_size(), job.max_layers, step, needs.every), {}, {}, {}, {}};
    std::optional<EventFinder> events;
    if (job.find_events) events.emplace(source.field_size());
    if (needs.flow) result.volume.keep_flow();
    result.summary = source.read(needs, [&](Frame&& frame, Field&& field) {
        result.volume.add(field, needs.colour ? frame.colour : Plane<Bgr>());
        if (events) events->add(field.scalar, {field.index, field.pts});
        if (result.volume.frames() == 1) result.first = frame;
        result.last = std::move(frame);
        if (progress) progress(result.volume.frames());
    });
    if (events) result.events = events->finish();
    return result;
}

std::vector<Brick> cut(const RenderJob& job, const Fields& fields) {
    const Volume& volume = fields.volume;
    const double frames = static_cast<double>(volume.frames());
    double brick_frames = static_cast<double>(job.brick_frames);
    const double seconds = fields.last.pts - fields.first.pts;
    if (job.brick_seconds > 0 && seconds > 0) brick_frames = job.brick_seconds / seconds * (frames - 1);
    if (brick_frames <= 0) return cut_into(volume.layers(), job.bricks);
    const double layers = std::round(brick_frames / static_cast<double>(volume.step()));
    return cut_by(volume.layers(), std::max<std::int64_t>(1, static_cast<std::int64_t>(layers)));
}

Plane<Bgr> standing_picture(const Frame& frame) {
    if (!frame.colour.empty()) return frame.colour;
    Plane<Bgr> picture(frame.grey.size());
    std::ranges::transform(frame.grey.pixels(), picture.pixels().begin(), [](std::uint8_t grey) {
        return Bgr{grey, grey, grey};
    });
    return picture;
}

Scene build_scene(const RenderJob& job, const Fields& fields, const Layout& layout) {
    Scene scene;
    if (job.show.contains("arrows")) scene.arrows = arrows(fields.volume, layout, job.glyphs);
    if (job.show.contains("tracelines")) scene.tracelines = tracelines(fields.volume, layout, job.traces);
    if (job.show.contains("outline")) scene.lines = volume_outline(layout, {0.55F, 0.58F, 0.62F, 1});
    if (job.show.contains("frames")) {
        constexpr float opacity = 0.5F;
        scene.frames.push_back({0, standing_picture(fields.first), opacity});
        scene.frames.push_back({1, standing_picture(fields.last), opacity});
    }
    return scene;
}

/// Fig. 5: what the renderer makes of its bricks.
void add_overlays(const RenderJob& job, const Renderer& renderer, const Layout& layout,
                  const TransferFunction& transfer, Scene& scene) {
    const auto add = [&scene](const std::vector<Segment>& lines) {
        scene.lines.insert(scene.lines.end(), lines.begin(), lines.end());
    };
    const AxisBox rendered = visible_box(renderer.place(), layout, transfer);
    if (job.show.contains("boxes")) {
        add(box_edges(layout_box(layout), {0.13F, 0.35F, 0.85F, 1}));
        add(box_edges(rendered, {0.88F, 0.68F, 0.05F, 1}));
    }
    if (job.show.contains("slices")) {
        constexpr int shown = 20;
        const Camera camera =
            job.slice_view ? fit_camera(*job.slice_view, outline_points(layout), job.picture.size) : renderer.camera();
        add(slice_outlines(rendered, camera, renderer.slices(camera), shown, {0.10F, 0.62F, 0.22F, 1}));
    }
}

bool nothing_visible(const Volume& volume, const TransferFunction& transfer) {
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        if (transfer.visible({0, std::ranges::max(volume.layer(i).scalar.pixels())})) return false;
    }
    return true;
}

Picture to_picture(const Plane<glm::vec4>& drawn) {
    Picture picture{Plane<Rgba>(drawn.size()), Encoding::srgb};
    std::ranges::transform(drawn.pixels(), picture.pixels.pixels().begin(), [](const glm::vec4& p) {
        return Rgba{p.x, p.y, p.z, p.w};
    });
    return picture;
}

}  // namespace

const std::vector<std::string>& show_words() {
    static const std::vector<std::string> words = {"volume", "arrows", "tracelines", "outline",
                                                   "frames", "boxes",  "slices"};
    return words;
}

std::int64_t planned_step(const RenderJob& job, std::int64_t frames) {
    if (job.step > 0) return job.step;
    return std::max<std::int64_t>(1, (frames + job.max_layers - 1) / job.max_layers);
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
    const auto context = open_context(job.backend, job.device);
    report.stages.end("context");
    const std::int64_t expected = source.expected_frames();
    std::int64_t step = planned_step(job, expected);
    Fields fields = read_fields(job, source, step, progress);
    // A header that promised far more than there was has wasted the window: read again, now knowing the length.
    if (job.step == 0 && step > 1 && fields.volume.layers() < job.max_layers / 2 && fields.volume.frames() > 1) {
        step = planned_step(job, fields.volume.frames());
        fields = read_fields(job, source, step, progress);
    }

    report.stages.end("fields");

    Volume& volume = fields.volume;
    report.events = std::move(fields.events);
    report.info = source.info();
    report.field_size = source.field_size();
    report.frames = fields.summary.frames;
    report.damaged = fields.summary.damaged;
    report.first_pts = fields.first.pts;
    report.last_pts = fields.last.pts;
    report.layers = volume.layers();
    report.step = volume.step();
    report.bricks = cut(job, fields);

    LayoutShape shape = shape_for(volume.size(), job.r_min, job.r_max);
    if (job.height > 0) shape.y_s = job.height;
    const auto layout = make_layout(job.layout, shape);
    Scene scene = build_scene(job, fields, *layout);
    report.arrows = scene.arrows.size();

    report.stages.end("scene");

    report.still = nothing_visible(volume, job.transfer);

    report.renderer = context->renderer();
    report.gl_version = context->version();
    report.backend = context->backend();
    RenderOptions options = job.picture;
    options.ring = static_cast<int>(report.bricks.size());
    options.window_layers = volume.layers();
    options.hold_box = job.show.contains("boxes") || job.show.contains("slices");
    Renderer renderer(*context, *layout, options);
    const TransferFunction transfer = job.transfer.scaled(job.opacity);
    renderer.set_transfer(transfer);
    if (job.show.contains("volume")) {
        for (std::size_t i = 0; i < report.bricks.size(); ++i) {
            const Brick& brick = report.bricks[i];
            renderer.push_brick(static_cast<std::int64_t>(i), brick_texels(volume, brick));
            volume.release_before(brick.first + brick.count - 1);  // the next brick repeats the last layer
        }
    }
    add_overlays(job, renderer, *layout, transfer, scene);
    renderer.set_scene(std::move(scene));
    for (int i = 0; i < job.pictures; ++i) {
        Picture picture = to_picture(renderer.draw(static_cast<double>(i) / job.pictures));
        report.stages.end("draw");
        sink(report, i, std::move(picture));
        report.stages.end("write");
    }
    return report;
}

}  // namespace vvr
