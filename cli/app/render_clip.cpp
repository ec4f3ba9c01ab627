#include "cli/app/render_clip.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/app/draw.h"
#include "cli/app/input.h"
#include "cli/app/objects.h"
#include "cli/app/plan.h"
#include "cli/app/report.h"
#include "cli/app/volume_paint.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/events/event_finder.h"
#include "core/fields/filter.h"
#include "core/fields/motion.h"
#include "core/scene/theme.h"

namespace vvr::app {

namespace {

// Fewer frames are read in a few seconds: reading begins before OpenGL is known to work.
constexpr std::int64_t soon_read = 5000;
// With more frames the renderer is made after they have been read: memory counts for more than a moment then.
constexpr std::int64_t long_read = 100'000;

/// The volume of a clip, and the frames at its ends.
struct Fields {
    bricks::Volume volume;
    video::SharedFrame first = std::make_shared<const video::Frame>();
    video::SharedFrame last = first;
    std::vector<KeyFrame> keyframes{};
    fields::FieldSummary summary{};
    std::optional<std::vector<events::Event>> events{};
    glance::Crops crops{};
};

/// A clip in layers of even time and in layers that go where something moves: which of them is better is known at its
/// end.
class Scales {
  public:
    Scales(const RenderJob& job, const fields::FieldSource& source, const bricks::Volume& empty) {
        const video::VideoInfo& info = source.info();
        if (info.rate > 0) length_ = static_cast<double>(source.expected_frames()) / info.rate;
        time_ = job.bricks.time;
        if (time_ == TimeScale::automatic && is_short_recording(source)) time_ = TimeScale::even;
        if (time_ != TimeScale::busy) even_.emplace(empty);
        if (time_ == TimeScale::even) return;
        busy_.emplace(empty);
        busy_->use_nonuniform_layers();
    }

    std::int64_t frames() const { return (even_ ? *even_ : *busy_).frames(); }

    void add(const fields::Field& field, const Plane<Bgr>& colour, std::span<const fields::LabelRun> owners) {
        fill_gap(field);
        const bool moves = busy_ && motion_(field);
        if (last_) (moves ? moving_ : idle_) += field.pts - last_->seconds;
        last_ = {field.index, field.pts};
        decide_early();
        if (even_) even_->add(field, colour, owners);
        if (busy_) busy_->add(field, colour, owners, moves);
    }

    /// The better one.
    bricks::Volume take() {
        if (busy_) busy_->settle();
        if (even_ && busy_) {
            const bool wins = idle_ > moving_ && moving_ > 0 && idle_ + moving_ > short_recording;
            (wins ? even_ : busy_).reset();
        }
        return std::move(busy_ ? *busy_ : *even_);
    }

  private:
    /// Lets go of what cannot win any more, if the header tells the length.
    void decide_early() {
        if (!even_ || !busy_ || length_ <= 0) return;
        if (moving_ > length_ / 2) busy_.reset();
        if (idle_ > length_ / 2 && moving_ > 0) even_.reset();
        if (!even_ || !busy_) trim_heap();
    }

    /// Numbers skip the frames of a gap in a recording.
    void fill_gap(const fields::Field& next) {
        if (!last_ || next.index <= last_->frame + 1) return;
        const std::int64_t gap = next.index - last_->frame - 1;
        const double apart = (next.pts - last_->seconds) / static_cast<double>(gap + 1);
        if (even_) even_->add_gap(last_->frame + 1, gap, last_->seconds + apart, apart);
        if (busy_) busy_->add_gap(last_->frame + 1, gap, last_->seconds + apart, apart);
    }

    TimeScale time_ = TimeScale::even;
    std::optional<bricks::Volume> even_;
    std::optional<bricks::Volume> busy_;
    fields::MotionDetector motion_;
    std::optional<Moment> last_;
    double length_ = 0;  ///< seconds, by the header; 0 = unknown
    double moving_ = 0;  ///< seconds
    double idle_ = 0;
};

/// A clip that is open has a frame, so it has changed since.
[[noreturn]] void throw_no_frame(const fields::FieldSource& source) {
    throw Error(
        ErrorKind::not_video,
        fmt::format("'{}' gives no frame any more; was it changed or removed while it was read?", source.info().name));
}

Fields read_fields(const RenderJob& job, const Products& products, fields::FieldSource& source, std::int64_t step,
                   Observer& observer) {
    const std::int64_t expected = source.expected_frames();
    const fields::FieldNeeds needs = needs_of(job, source, expected > 0 ? expected : step * job.bricks.max_layers);

    Fields result{bricks::Volume(source.field_size(), job.bricks.max_layers, step, needs.every)};
    result.volume.set_values(job.fields.filter->traits.values);
    const int keyframes = job.look.keyframes;
    std::optional<events::EventFinder> events;
    events::FrameLabels labels;
    VolumePaint paint(job);
    const video::Frame* now = nullptr;
    if (finds_objects(job, products)) events.emplace(source.field_size(), event_options(job));
    if (events && (products.portraits || job.look.show.has(Part::portraits))) {
        events->set_portrait_sink(
            [&](std::size_t track, const events::Portrait& portrait) { result.crops.keep(track, portrait, *now); });
    }
    if (events && job.picture.colour == gl::VolumeColour::object) {
        result.volume.keep_owners();
        events->set_label_sink([&labels](const events::FrameLabels& of_field) { labels = of_field; });
    }
    if (needs.flow) result.volume.keep_flow();
    Scales scales(job, source, result.volume);
    result.summary = source.read(needs, [&](const video::SharedFrame& frame, const fields::Field& field) {
        now = frame.get();
        if (events) events->add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts});
        scales.add(field, paint(*frame, field), labels.runs);
        if (scales.frames() == 1) result.first = frame;
        const std::int64_t number = scales.frames() - 1;
        const auto wanted = static_cast<std::int64_t>(result.keyframes.size()) + 1;
        if (expected > 0 && wanted <= keyframes && number == wanted * (expected - 1) / (keyframes + 1)) {
            result.keyframes.push_back({frame, number});
        }
        result.last = frame;
        observer.frames(scales.frames(), expected);
    });
    if (scales.frames() == 0) throw_no_frame(source);
    result.volume = scales.take();
    if (events) result.events = events::choose_events(events->finish(result.summary.reference), job.output.events);
    return result;
}

std::vector<bricks::Brick> cut(const BrickOptions& bricks, const Fields& fields, const WallClock& clock) {
    const bricks::Volume& volume = fields.volume;
    if (!bricks.length) return bricks::cut_into(volume.layers(), bricks.window);
    double brick_frames = bricks.length->value;
    if (volume.is_nonuniform() && bricks.length->unit == Time::Unit::frames) {
        return bricks::cut_by_frames(volume, std::max<std::int64_t>(1, std::llround(brick_frames)));
    }
    if (bricks.length->unit == Time::Unit::seconds) {
        // Where layers are of unequal length, only the clock says how long a brick is.
        if (volume.is_nonuniform()) {
            return bricks::cut_by_clock(volume, bricks.length->value, clock ? clock->at(0) : 0);
        }
        const double seconds = fields.last->pts - fields.first->pts;
        if (seconds <= 0) return bricks::cut_into(volume.layers(), bricks.window);
        brick_frames *= static_cast<double>(volume.frames() - 1) / seconds;
    }
    const double layers = std::round(brick_frames / static_cast<double>(volume.step()));
    return bricks::cut_by(volume.layers(), std::max<std::int64_t>(1, static_cast<std::int64_t>(layers)));
}

/// Moves what the empty scene holds to the time at which it was there: the fields show a ghost of it instead.
void correct_ghosts(std::span<const events::Event> events, bricks::Volume& volume) {
    for (const events::Event& event : events) {
        if (!event.in_scene || event.tracks.empty()) continue;
        for (const std::size_t track : event.tracks) volume.remove_track(track);
        volume.insert_track(event.tracks.front(), event.in_scene->box, event.in_scene->values, event.first.seconds,
                            event.last.seconds);
    }
}

/// What the empty scene holds is seen best in it: what was left for most of the clip, and what was taken.
void take_stills_from_scene(std::span<const events::Event> events, const Plane<Bgr>& scene, glance::Crops& crops) {
    constexpr double best = std::numeric_limits<double>::max();
    const video::Frame frame{0, 0, Plane<std::uint8_t>(scene.size()), scene};
    for (const events::Event& event : events) {
        const bool in_scene = event.in_scene.has_value() || row_of(event.kind).is_of_scene;
        if (!in_scene || event.tracks.empty()) continue;
        crops.keep(event.tracks.front(), {event.first, event.box, best}, frame);
    }
}

/// The empty scene; without one, the last frame.
Plane<Bgr> scene_of(const Fields& fields) {
    const fields::Planes& scene = fields.summary.reference;
    if (scene.empty()) return video::picture_of(*fields.last);
    return video::picture_of(video::Frame{0, 0, scene.grey, scene.colour});
}

/// OpenGL's memory is given back before the libraries that encode pictures take as much.
void close(Drawing& drawing) {
    { const Drawing closed = std::move(drawing); }
    trim_heap();
}

/// All after the fields: draws each picture and gives it to the sink.
void draw_pictures(const RenderJob& job, const Products& products, Fields& fields, Drawing& drawing,
                   RenderReport& report, const PictureSink& sink) {
    if (fields.events && fields.volume.keeps_owners()) correct_ghosts(*fields.events, fields.volume);
    const bricks::Volume& volume = fields.volume;
    const space::Layout& layout = *drawing.layout;
    const WallClock clock = clock_of(job.look.start_time, report.info);
    const std::vector<bricks::Brick> bricks = cut(job.bricks, fields, clock);
    const Caption caption{title_of(job.look.title, report.info),
                          fields.summary.frames,
                          fields.first->pts,
                          fields.last->pts,
                          nothing_visible(volume, transfer_of(job.look)),
                          clock};
    report.events = fields.events;
    report.clock = clock;
    report.advice = advice_on(job, report);
    const bricks::Identify identify = volume.keeps_owners() ? objects_of(*fields.events, volume) : bricks::Identify{};
    report.frames = caption.frames;
    report.damaged = fields.summary.damaged;
    report.problems = fields.summary.problems;
    report.first_frame = fields.first->index;
    report.last_frame = fields.last->index;
    report.first_pts = caption.begin;
    report.last_pts = caption.end;
    report.layers = volume.layers();
    report.step = volume.step();
    report.squeezed = bricks::compressed_stretches(volume);
    report.bricks = bricks;
    report.still = caption.still;

    const Plane<Bgr> scene_picture = scene_of(fields);
    if (fields.events) take_stills_from_scene(*fields.events, scene_picture, fields.crops);
    const Glance glance{
        fields.events ? shown_objects(job.look, *fields.events, caption.begin, caption.end, clock) : glance::Objects{},
        &fields.crops,
        scene_picture,
        video::picture_of(*fields.first),
        video::picture_of(*fields.last),
        volume.size()};
    const std::vector<labels::TimeTick> ticks = ticks_of(job, drawing.framing, volume, clock);
    scene::Scene scene = build_scene(job, volume, {*fields.first, *fields.last, fields.keyframes, bricks}, layout,
                                     drawing.framing, ticks, glance.objects, identify);
    report.arrows = scene.arrows.size();
    report.keyframes = fields.keyframes.size();
    report.stages.end("scene");

    const std::vector<bricks::Brick> pieces = job.look.show.has(Part::volume)
                                                  ? sub_bricks_of(bricks, fields.keyframes, volume)
                                                  : std::vector<bricks::Brick>{};
    const int textures = textures_of(products, static_cast<int>(pieces.size()));
    drawing.window = std::make_unique<gl::BrickWindow>(drawing.context->gl(), layout, volume.layers(), textures,
                                                       half_pixel(job, drawing));
    drawing.window->show(volume, pieces, 0, identify);
    if (volume.keeps_owners() && fields.events->empty()) {
        // Where there is no object, what changed is all that there is to be seen.
        std::vector<glm::vec4> looks = scene::object_palette(job.look.theme);
        looks.front().a = 1;
        drawing.renderer->set_palette(looks);
    }
    add_overlays(job, drawing, bricks, volume.layers(), scene);
    drawing.renderer->set_scene(std::move(scene));
    const labels::Lettering lettering = letter(job, caption, volume, layout, drawing.framing, ticks, glance);
    report.lettering = lettering;
    report.event_colours = glance.objects.colours;
    if (products.portraits && fields.events) report.portraits = glance::portraits_of(*fields.events, fields.crops);
    for (int i = 0; i < products.pictures; ++i) {
        const double phase = static_cast<double>(i) / products.pictures;
        image::Picture picture = draw_picture(products.pixel_data, drawing, volume, lettering, phase);
        report.stages.end("draw");
        report.pictures = i + 1;
        if (report.pictures == products.pictures) close(drawing);
        sink(report, i, std::move(picture));
        report.stages.end("write");
    }
}

}  // namespace

RenderReport render_clip(const RenderJob& job, const Products& products, fields::FieldSource& source,
                         Observer& observer, const PictureSink& sink) {
    RenderReport report;  // its stages begin now
    const std::int64_t expected = source.expected_frames();
    const Size field_size = source.field_size();
    RenderThread thread;
    auto opened = thread.start([&job, &observer](Drawing& drawing) { open_context(job, drawing, observer); });
    // The libraries take a second core's time to load, and the driver to compile shaders: meanwhile the clip is read.
    if (expected <= long_read) {
        thread.start([&job, field_size](Drawing& drawing) {
            make_renderer(job, field_size, gl::RenderOptions{}.tile_samples, drawing);
            warm_up(job, drawing);
        });
    }
    if (expected == 0 || expected > soon_read) opened.get();
    std::int64_t step = planned_step(job.bricks, expected);
    Fields fields = read_fields(job, products, source, step, observer);
    // A header that promised far more than there was has wasted the window: read again, now knowing the length.
    if (job.bricks.step == 0 && step > 1 && !fields.volume.is_nonuniform() &&
        fields.volume.layers() < job.bricks.max_layers / 2 && fields.volume.frames() > 1) {
        step = planned_step(job.bricks, fields.volume.frames());
        fields = read_fields(job, products, source, step, observer);
    }

    report.stages.end("fields");
    thread.run([&](Drawing& drawing) {
        if (!drawing.renderer) make_renderer(job, field_size, gl::RenderOptions{}.tile_samples / 4, drawing);
        describe(source, *drawing.context, report);
        draw_pictures(job, products, fields, drawing, report, sink);
    });
    return report;
}

std::vector<events::Event> find_events(const RenderJob& job, fields::FieldSource& source, Observer& observer) {
    Products products{.pictures = 0};
    products.events = true;
    Fields fields = read_fields(job, products, source, planned_step(job.bricks, source.expected_frames()), observer);
    return std::move(*fields.events);
}

}  // namespace vvr::app
