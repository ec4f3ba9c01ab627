#include "cli/app/render_series.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/app/draw.h"
#include "cli/app/input.h"
#include "cli/app/objects.h"
#include "cli/app/plan.h"
#include "cli/app/report.h"
#include "cli/app/volume_paint.h"
#include "core/events/event_finder.h"
#include "core/fields/filter.h"

namespace vvr::app {

namespace {

/// The window while it slides: its volume, and what is drawn of it.
class Series {
  public:
    /// \param thread whose drawing has a renderer
    Series(const RenderJob& job, const Products& products, const fields::FieldSource& source, RenderThread& thread,
           RenderReport begun, const PictureSink& sink)
        : job_(job),
          pixel_data_(products.pixel_data),
          pictures_of_brick_(products.pictures),
          window_(sliding_window(job.bricks, source)),
          volume_(source.field_size(), std::max<std::int64_t>(2, window_.layers()), window_.step,
                  needs_of(job, source, window_.frames()).every),
          thread_(thread),
          pieces_of_brick_(std::ssize(bricks::cut_into_sub_bricks(
              bricks::cut_at(std::array{bricks::Brick{0, window_.brick_layers}}, key_layers())))),
          transfer_(drawn_transfer_of(job.look)),
          paint_(job),
          sink_(sink),
          report_(std::move(begun)) {
        caption_.title = title_of(job.look.title, report_.info);
        caption_.clock = clock_of(job.look.start_time, report_.info);
        volume_.set_span(window_.layers());
        volume_.set_values(job.fields.filter->traits.values);
        if (job.look.show.any(&PartRow::needs_flow)) volume_.keep_flow();
        thread_.run([&, this](Drawing& drawing) {
            const int textures = textures_of(products, window_.bricks * static_cast<int>(pieces_of_brick_));
            drawing.window = std::make_unique<gl::BrickWindow>(drawing.context->gl(), *drawing.layout, window_.layers(),
                                                               textures, half_pixel(job, drawing));
        });
        if (finds_objects(job, products)) events_.emplace(source.field_size(), event_options(job_));
        tells_events_ = products.events;
        shows_portraits_ = products.portraits;
        if (events_ && (shows_portraits_ || job.look.show.has(Part::portraits))) {
            events_->set_portrait_sink(
                [this](std::size_t track, const events::Portrait& portrait) { crops_.keep(track, portrait, *frame_); });
        }
        if (job.picture.colour == gl::VolumeColour::object) {
            volume_.keep_owners();
            identify_ = objects_.identify();
            events_->set_label_sink([this](const events::FrameLabels& labels) {
                labels_ = labels;
                objects_.see(labels);
            });
        }
        report_.clock = caption_.clock;
        report_.step = window_.step;
        report_.pictures = 0;
    }

    void add(const video::SharedFrame& frame, const fields::Field& field) {
        if (begin_) fill_gap(field);
        if (!begin_) begin_ = {field.index, field.pts};
        if (volume_.frames() == window_.frames()) drop_oldest();
        frame_ = frame.get();
        if (events_) events_->add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts});
        volume_.add(field, paint_(*frame, field), labels_.runs);
        if (frames_of_newest_ == 0) first_of_bricks_.push_back(frame);
        keep_key_frame(frame);
        last_ = frame;
        if (++frames_of_newest_ == window_.brick_frames()) complete_newest(Draw::yes);
    }

    /// After the last frame: the last brick may be shorter than the others. Frames and times are those of the clip, all
    /// else is that of the last window.
    /// \param scene the empty scene; may be empty
    RenderReport finish(const fields::Planes& scene) {
        if (frames_of_newest_ > 0) complete_newest(Draw::yes);
        report_.stages.end("fields");
        report_.still = all_still_;
        report_.events.reset();
        report_.event_numbers.clear();
        report_.event_colours.clear();
        if (tells_events_) report_.events = events::choose_events(events_->finish(scene), job_.output.events);
        if (begin_) {
            report_.first_frame = begin_->frame;
            report_.first_pts = begin_->seconds;
        }
        return report_;
    }

  private:
    enum class Draw { no, yes };

    /// Layers of a brick at whose beginning key frames stand: they part it evenly.
    std::vector<std::int64_t> key_layers() const {
        std::vector<std::int64_t> layers;
        for (std::int64_t j = 0; j < job_.look.keyframes; ++j) {
            layers.push_back(j * window_.brick_layers / job_.look.keyframes);
        }
        return layers;
    }

    /// Keeps the newest frame if one stands there. None does at the volume's beginning, where its first frame stands.
    void keep_key_frame(const video::SharedFrame& frame) {
        if (frames_of_newest_ % window_.step != 0) return;
        const std::vector<std::int64_t> layers = key_layers();
        if (std::ranges::find(layers, frames_of_newest_ / window_.step) == layers.end()) return;
        keyframes_.push_back({frame, volume_.frames() - 1});
    }

    void drop_oldest() {
        volume_.drop_front(window_.brick_layers);
        first_of_bricks_.pop_front();
        for (KeyFrame& key : keyframes_) key.number -= window_.brick_frames();
        std::erase_if(keyframes_, [](const KeyFrame& key) { return key.number < 0; });
    }

    /// A stream's numbers skip the frames that never came. A brick that holds nothing but such a gap gets no picture;
    /// one that frames began is drawn with them, whatever comes after. Of a gap longer than the window only the end is
    /// shown.
    void fill_gap(const fields::Field& next) {
        const std::int64_t gap = next.index - last_->index - 1;
        const double length = (next.pts - last_->pts) / static_cast<double>(gap + 1);
        const std::int64_t brick = window_.brick_frames();
        const std::int64_t of_newest = frames_of_newest_ > 0 ? std::min(gap, brick - frames_of_newest_) : 0;
        for (std::int64_t i = 1; i <= of_newest; ++i) {
            add_missing(last_->index + i, last_->pts + static_cast<double>(i) * length, Draw::yes);
        }
        for (std::int64_t i = std::min(gap - of_newest, window_.frames()); i > 0; --i) {
            add_missing(next.index - i, next.pts - static_cast<double>(i) * length, Draw::no);
        }
    }

    /// \param wanted what to do with a brick that this ends
    void add_missing(std::int64_t index, double pts, Draw wanted) {
        if (volume_.frames() == window_.frames()) drop_oldest();
        volume_.add_missing(index, pts);
        if (frames_of_newest_ == 0) {
            first_of_bricks_.push_back(std::make_shared<const video::Frame>(video::Frame{index, pts, {}, {}}));
        }
        if (++frames_of_newest_ == window_.brick_frames()) complete_newest(wanted);
    }

    void complete_newest(Draw wanted) {
        report_.stages.end("fields");
        update_report();
        objects_.decide(report_.first_frame);
        if (wanted == Draw::yes) thread_.run([this](Drawing& drawing) { draw(drawing); });
        ++newest_;
        frames_of_newest_ = 0;
    }

    void update_report() {
        const video::Frame& first = *first_of_bricks_.front();
        bricks_ = bricks::cut_by(volume_.layers(), window_.brick_layers);
        caption_.frames = volume_.frames() - volume_.missing();
        caption_.begin = first.pts;
        caption_.end = last_->pts;
        caption_.still = nothing_visible(volume_, transfer_);
        all_still_ = all_still_ && caption_.still;
        report_.frames = caption_.frames;
        report_.first_frame = first.index;
        report_.first_pts = caption_.begin;
        report_.last_pts = caption_.end;
        report_.last_frame = last_->index;
        report_.layers = volume_.layers();
        report_.bricks = bricks_;
        report_.still = caption_.still;
    }

    /// The key frames but the one at the volume's beginning: its first frame stands there.
    std::span<const KeyFrame> standing() const {
        const std::span<const KeyFrame> all = keyframes_;
        return !all.empty() && all.front().number == 0 ? all.subspan(1) : all;
    }

    /// Number of the first brick in the window.
    std::int64_t oldest() const { return newest_ - std::ssize(bricks_) + 1; }

    /// Pieces of bricks are numbered from the clip's first on, so only what is new is uploaded.
    void show_sub_bricks(gl::BrickWindow& window) const {
        window.show(volume_, sub_bricks_of(bricks_, keyframes_, volume_), oldest() * pieces_of_brick_, identify_);
    }

    void draw(Drawing& drawing) {
        const Glance glance = glance_now();
        if (job_.look.show.has(Part::volume)) show_sub_bricks(*drawing.window);
        report_.stages.end("draw");
        const std::vector<labels::TimeTick> ticks = ticks_of(job_, drawing.framing, volume_, caption_.clock);
        const bool shows_frames = job_.look.show.has(Part::frames);
        scene::Scene scene =
            build_scene(job_, volume_, {*first_of_bricks_.front(), *last_, standing(), bricks_, oldest()},
                        *drawing.layout, drawing.framing, ticks, glance.objects, identify_);
        report_.arrows = scene.arrows.size();
        report_.stages.end("scene");
        report_.frames_missing =
            report_.frames_missing || (shows_frames && volume_.missing() == 0 && scene.frames.size() < 2);
        add_overlays(job_, drawing, bricks_, window_.layers(), scene);
        drawing.renderer->set_scene(std::move(scene));
        const labels::Lettering lettering =
            letter(job_, caption_, volume_, *drawing.layout, drawing.framing, ticks, glance);
        report_.lettering = lettering;
        for (int i = 0; i < pictures_of_brick_; ++i) {
            image::Picture picture = draw_picture(pixel_data_, drawing, volume_, lettering, phase());
            report_.stages.end("draw");
            ++report_.pictures;
            sink_(report_, static_cast<int>(newest_), std::move(picture));
            report_.stages.end("write");
        }
    }

    /// Of the tracelines' texture: stripes run on from picture to picture (§6.2.1), faster in stills, which are few.
    double phase() const {
        constexpr std::int64_t stills = 8;  // over which the texture moves on by one stripe
        if (!job_.output.slide) return static_cast<double>(newest_ % stills) / stills;
        return static_cast<double>(report_.pictures % default_animation) / default_animation;
    }

    /// What is known of the objects in the window by now: as if the clip ended here.
    Glance glance_now() {
        Glance glance;
        glance.field = volume_.size();
        glance.first = video::picture_of(*first_of_bricks_.front());
        glance.last = video::picture_of(*last_);
        if (!events_) return glance;
        constexpr double link_seconds = 60;  // somebody who went may come back as the same object
        if (!tells_events_) events_->forget_ended_before(caption_.begin - link_seconds);
        events::EventFinder until_now = *events_;
        const std::vector<events::Event> events = events::choose_events(until_now.finish(), job_.output.events);
        glance.objects = shown_objects(job_.look, events, caption_.begin, caption_.end, caption_.clock);
        for (std::size_t k = 0; k < glance.objects.events.size(); ++k) {
            const std::vector<std::size_t>& tracks = glance.objects.events[k].tracks;
            // Once shown, an object keeps its number, and its colour is that of its voxels.
            glance.objects.numbers[k] = numbers_.try_emplace(tracks.front(), numbers_.size() + 1).first->second;
            for (const std::size_t track : tracks) {
                const std::optional<int> colour = objects_.colour_of(track);
                if (colour) glance.objects.colours[k] = job_.look.theme.objects[static_cast<std::size_t>(*colour)];
                objects_.give_number(track, glance.objects.numbers[k]);
            }
        }
        report_.events = glance.objects.events;
        report_.event_numbers = glance.objects.numbers;
        report_.event_colours = glance.objects.colours;
        if (shows_portraits_) report_.portraits = glance::portraits_of(glance.objects.events, crops_);
        glance.crops = &crops_;
        glance.scene = glance.first;
        return glance;
    }

    const RenderJob& job_;
    bool pixel_data_;
    int pictures_of_brick_;
    SlidingWindow window_;
    bricks::Volume volume_;
    RenderThread& thread_;
    std::int64_t pieces_of_brick_;  ///< fewer of the clip's last one, if it is shorter
    scene::TransferFunction transfer_;
    VolumePaint paint_;
    const PictureSink& sink_;
    std::vector<bricks::Brick> bricks_;  ///< in the window
    Caption caption_;                    ///< of the window
    RenderReport report_;
    std::optional<events::EventFinder> events_;
    glance::Crops crops_;
    const video::Frame* frame_ = nullptr;  ///< that is being added
    bool tells_events_ = false;
    bool shows_portraits_ = false;
    LiveObjects objects_;
    bricks::Identify identify_;                       ///< of `objects_`
    events::FrameLabels labels_;                      ///< of the newest field
    std::map<std::size_t, std::size_t> numbers_;      ///< of the events that were shown, by their first track
    std::optional<Moment> begin_;                     ///< of the clip
    bool all_still_ = true;                           ///< nothing was visible in any window
    std::deque<video::SharedFrame> first_of_bricks_;  ///< of the bricks in the window
    std::vector<KeyFrame> keyframes_;                 ///< in the window
    video::SharedFrame last_;
    std::int64_t newest_ = 0;  ///< number of the brick that is being filled
    std::int64_t frames_of_newest_ = 0;
};

}  // namespace

RenderReport render_series(const RenderJob& job, const Products& products, fields::FieldSource& source,
                           Observer& observer, const PictureSink& sink) {
    RenderReport begun;
    RenderThread thread;
    thread.run([&](Drawing& drawing) {
        open_context(job, drawing, observer);
        describe(source, *drawing.context, begun);
        make_renderer(job, source.field_size(), gl::RenderOptions{}.tile_samples, drawing);
    });
    Series series(job, products, source, thread, std::move(begun), sink);
    const fields::FieldNeeds needs = needs_of(job, source, sliding_window(job.bricks, source).frames());
    std::int64_t frames = 0;
    const std::int64_t expected = source.expected_frames();
    const fields::FieldSummary summary =
        source.read(needs, [&](const video::SharedFrame& frame, const fields::Field& field) {
            series.add(frame, field);
            observer.frames(++frames, expected);
        });
    RenderReport report = series.finish(summary.reference);
    report.frames = summary.frames;
    report.damaged = summary.damaged;
    report.problems = summary.problems;
    report.info = source.info();  // by now it tells all files of a recording
    report.advice = advice_on(job, report);
    return report;
}

}  // namespace vvr::app
