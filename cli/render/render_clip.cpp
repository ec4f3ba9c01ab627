#include "cli/render/render_clip.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "cli/render/build_scene.h"
#include "cli/render/layers.h"
#include "cli/render/objects.h"
#include "cli/render/render_thread.h"
#include "cli/render/shown_name.h"
#include "core/events/event_finder.h"
#include "core/machine_memory.h"
#include "core/scene/object_looks.h"

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
    Crops crops{};
};

/// Numbers skip the frames of a gap in a recording.
void fill_gap(const Field& next, Volume& volume) {
    if (volume.frames() == 0) return;
    const Layer& before = volume.layer(volume.layers() - 1);
    const std::int64_t gap = next.index - before.last_frame - 1;
    const double begin = before.last_pts;
    const double length = (next.pts - begin) / static_cast<double>(gap + 1);
    for (std::int64_t i = 1; i <= gap; ++i) {
        volume.add_missing(next.index - gap - 1 + i, begin + static_cast<double>(i) * length);
    }
}

Fields read_fields(const RenderJob& job, const Products& products, FieldSource& source, std::int64_t step,
                   Observer& observer) {
    const std::int64_t expected = source.expected_frames();
    const FieldNeeds needs = needs_of(job, source, expected > 0 ? expected : step * job.bricks.max_layers);

    Fields result{Volume(source.field_size(), job.bricks.max_layers, step, needs.every)};
    const int keyframes = job.look.keyframes;
    std::optional<EventFinder> events;
    FrameLabels labels;
    const Frame* now = nullptr;
    if (finds_objects(job, products)) events.emplace(source.field_size(), event_options(job));
    if (events && job.look.show.has(Part::portraits)) {
        events->set_portrait_sink(
            [&](std::size_t track, const Portrait& portrait) { result.crops.keep(track, portrait, *now); });
    }
    if (events && job.picture.colour == VolumeColour::object) {
        result.volume.keep_owners();
        events->set_label_sink([&labels](const FrameLabels& of_field) { labels = of_field; });
    }
    if (needs.flow) result.volume.keep_flow();
    result.summary = source.read(needs, [&](const SharedFrame& frame, const Field& field) {
        now = frame.get();
        if (events) events->add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts});
        // Where nothing moves frames are left out on purpose.
        if (job.bricks.skip_idle == 0) fill_gap(field, result.volume);
        result.volume.add(field, volume_colour(job, *frame), labels.runs);
        if (result.volume.frames() == 1) result.first = frame;
        const std::int64_t number = result.volume.frames() - 1;
        const auto wanted = static_cast<std::int64_t>(result.keyframes.size()) + 1;
        if (expected > 0 && wanted <= keyframes && number == wanted * (expected - 1) / (keyframes + 1)) {
            result.keyframes.push_back({frame, number});
        }
        result.last = frame;
        observer.frames(result.volume.frames(), expected);
    });
    if (events) result.events = choose_events(events->finish(result.summary.reference), job.output.events);
    return result;
}

std::vector<Brick> cut(const BrickOptions& bricks, const Fields& fields, const WallClock& clock) {
    const Volume& volume = fields.volume;
    if (!bricks.length) return cut_into(volume.layers(), bricks.window);
    double brick_frames = bricks.length->value;
    if (bricks.length->unit == Time::Unit::seconds) {
        // Where parts are left out, only the clock says how long a brick is.
        if (volume.left_out() > 0) {
            return cut_by_clock(volume, bricks.length->value, static_cast<double>(clock.value_or(0)));
        }
        const double seconds = fields.last->pts - fields.first->pts;
        if (seconds <= 0) return cut_into(volume.layers(), bricks.window);
        brick_frames *= static_cast<double>(volume.frames() - 1) / seconds;
    }
    const double layers = std::round(brick_frames / static_cast<double>(volume.step()));
    return cut_by(volume.layers(), std::max<std::int64_t>(1, static_cast<std::int64_t>(layers)));
}

/// Moves what the empty scene holds to the time at which it was there: the fields show a ghost of it instead.
void set_ghosts_right(std::span<const Event> events, Volume& volume) {
    for (const Event& event : events) {
        if (!event.in_scene || event.tracks.empty()) continue;
        for (const std::size_t track : event.tracks) volume.take_out(track);
        volume.put_in(event.tracks.front(), event.in_scene->box, event.in_scene->values, event.first.seconds,
                      event.last.seconds);
    }
}

/// What the empty scene holds is seen best in it: what was left for most of the clip, and what was taken.
void take_stills_from_scene(std::span<const Event> events, const Plane<Bgr>& scene, Crops& crops) {
    constexpr double best = std::numeric_limits<double>::max();
    const Frame frame{0, 0, Plane<std::uint8_t>(scene.size()), scene};
    for (const Event& event : events) {
        const bool in_scene = event.in_scene.has_value() || event.kind == EventKind::taken;
        if (!in_scene || event.tracks.empty()) continue;
        crops.keep(event.tracks.front(), {event.first, event.box, best}, frame);
    }
}

/// The empty scene; without one, the last frame.
Plane<Bgr> scene_of(const Fields& fields) {
    const Planes& scene = fields.summary.reference;
    if (scene.empty()) return picture_of(*fields.last);
    return picture_of(Frame{0, 0, scene.grey, scene.colour});
}

/// OpenGL's memory is given back before the libraries that encode pictures take as much.
void close(Drawing& drawing) {
    { const Drawing closed = std::move(drawing); }
    give_back_freed();
}

/// All after the fields: draws each picture and gives it to the sink.
void draw_pictures(const RenderJob& job, const Products& products, Fields& fields, Drawing& drawing,
                   RenderReport& report, const PictureSink& sink) {
    if (fields.events && fields.volume.keeps_owners()) set_ghosts_right(*fields.events, fields.volume);
    const Volume& volume = fields.volume;
    const Layout& layout = *drawing.layout;
    const WallClock clock = clock_of(job.look.start_time, report.info);
    const std::vector<Brick> bricks = cut(job.bricks, fields, clock);
    const Caption caption{title_of(job.look.title, report.info),
                          fields.summary.frames,
                          fields.first->pts,
                          fields.last->pts,
                          nothing_visible(volume, transfer_of(job.look)),
                          clock};
    report.events = fields.events;
    const Identify identify = volume.keeps_owners() ? objects_of(*fields.events, volume) : Identify{};
    report.frames = caption.frames;
    report.damaged = fields.summary.damaged;
    report.problems = fields.summary.problems;
    report.first_frame = fields.first->index;
    report.last_frame = fields.last->index;
    report.first_pts = caption.begin;
    report.last_pts = caption.end;
    report.layers = volume.layers();
    report.step = volume.step();
    report.bricks = bricks;
    report.still = caption.still;

    const Plane<Bgr> scene_picture = scene_of(fields);
    if (fields.events) take_stills_from_scene(*fields.events, scene_picture, fields.crops);
    const Glance glance{
        fields.events ? shown_objects(job.look, *fields.events, caption.begin, caption.end, clock) : Objects{},
        &fields.crops,
        scene_picture,
        picture_of(*fields.first),
        picture_of(*fields.last),
        volume.size()};
    const std::vector<TimeTick> ticks = ticks_of(job, drawing.framing, volume, clock);
    Scene scene = build_scene(job, volume, {*fields.first, *fields.last, fields.keyframes}, layout, drawing.framing,
                              ticks, glance.objects, identify);
    report.arrows = scene.arrows.size();
    report.keyframes = fields.keyframes.size();
    report.stages.end("scene");

    const std::vector<Brick> pieces = job.look.show.has(Part::volume) ? cut_into_pieces(bricks) : std::vector<Brick>{};
    const int textures = textures_of(products, static_cast<int>(pieces.size()));
    drawing.window = std::make_unique<BrickWindow>(drawing.context->gl(), layout, volume.layers(), textures);
    drawing.window->show(volume, pieces, 0, identify);
    if (volume.keeps_owners() && fields.events->empty()) {
        // Where there is no object, what changed is all that there is to be seen.
        std::vector<glm::vec4> looks = looks_of(job.look.theme);
        looks.front().a = 1;
        drawing.renderer->set_looks(looks);
    }
    add_overlays(job, drawing, bricks, volume.layers(), scene);
    drawing.renderer->set_scene(std::move(scene));
    const Lettering lettering = letter(job, caption, volume, layout, drawing.framing, ticks, glance);
    report.lettering = lettering;
    report.event_colours = glance.objects.colours;
    for (int i = 0; i < products.pictures; ++i) {
        const double phase = static_cast<double>(i) / products.pictures;
        Picture picture = draw_picture(products.pixel_data, drawing, volume, lettering, phase);
        report.stages.end("draw");
        report.pictures = i + 1;
        if (report.pictures == products.pictures) close(drawing);
        sink(report, i, std::move(picture));
        report.stages.end("write");
    }
}

}  // namespace

RenderReport render_clip(const RenderJob& job, const Products& products, FieldSource& source, Observer& observer,
                         const PictureSink& sink) {
    RenderReport report;  // its stages begin now
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
    std::int64_t step = planned_step(job.bricks, expected);
    Fields fields = read_fields(job, products, source, step, observer);
    // A header that promised far more than there was has wasted the window: read again, now knowing the length.
    if (job.bricks.step == 0 && step > 1 && fields.volume.layers() < job.bricks.max_layers / 2 &&
        fields.volume.frames() > 1) {
        step = planned_step(job.bricks, fields.volume.frames());
        fields = read_fields(job, products, source, step, observer);
    }

    report.stages.end("fields");
    thread.run([&](Drawing& drawing) {
        if (!drawing.renderer) make_renderer(job, field_size, RenderOptions{}.tile_samples / 4, drawing);
        describe(source, *drawing.context, report);
        draw_pictures(job, products, fields, drawing, report, sink);
    });
    return report;
}

}  // namespace vvr
