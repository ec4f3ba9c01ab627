#include "cli/compose/compose.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/theme.h"

namespace vvr::app {

namespace {

std::vector<volume::Brick> cut(const ComposePlan& plan, const Observation& seen) {
    const volume::Volume& volume = seen.volume;
    const BrickOptions& bricks = plan.volume.bricks;
    if (plan.volume.series) return volume::cut_by(volume.layers(), plan.volume.window.brick_layers);
    if (!bricks.length) return volume::cut_into(volume.layers(), bricks.window);
    double brick_frames = bricks.length->value;
    if (volume.is_nonuniform() && bricks.length->unit == Time::Unit::frames) {
        return volume::cut_by_frames(volume, std::max<std::int64_t>(1, std::llround(brick_frames)));
    }
    if (bricks.length->unit == Time::Unit::seconds) {
        // With layers of unequal length, bricks can only be cut by the clock.
        if (volume.is_nonuniform()) {
            return volume::cut_by_clock(volume, bricks.length->value, plan.read.clock ? plan.read.clock->at(0) : 0);
        }
        const double seconds = seen.end().seconds - seen.begin.seconds;
        if (seconds <= 0) return volume::cut_into(volume.layers(), bricks.window);
        brick_frames *= static_cast<double>(volume.frames() - 1) / seconds;
    }
    const double layers = std::round(brick_frames / static_cast<double>(volume.step()));
    return volume::cut_by(volume.layers(), std::max<std::int64_t>(1, static_cast<std::int64_t>(layers)));
}

bool nothing_visible(const volume::Volume& volume, const scene::TransferFunction& transfer) {
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        if (transfer.visible({0, volume.layer(i).scalar.greatest()})) return false;
    }
    return true;
}

annotation::Objects objects_to_show(const ComposePlan& plan, const Observation& seen) {
    annotation::Objects objects;
    objects.end = seen.end().seconds;
    objects.clock = plan.read.clock;
    if (!seen.events) return objects;
    objects.events = seen.events->events;
    objects.numbers = seen.events->numbers;
    for (const int colour : seen.events->colours)
        objects.colours.push_back(plan.look.theme.objects[static_cast<std::size_t>(colour)]);
    return objects;
}

/// The times that the ruler marks.
std::vector<annotation::TimeTick> ticks_of(const ComposePlan& plan, const Framing& framing,
                                           const volume::Volume& volume) {
    if (!plan.look.shows(Part::ruler) || framing.sheet.text == 0 || volume.layers() == 0) return {};
    const int most = std::clamp(framing.sheet.picture.width / (8 * framing.sheet.text), 3, 11);
    if (volume.is_nonuniform()) return annotation::spread_ticks(volume, most, plan.read.clock);
    return annotation::time_ticks(volume.layer(0).pts, volume.layer(volume.layers() - 1).last_pts, most,
                                  plan.read.clock);
}

/// The layer that begins with the key frame. A piece of the volume ends there, so that it and the frame hide each other
/// correctly.
std::int64_t layer_of(const KeyFrame& key, const volume::Volume& volume) {
    return key.number / volume.step();
}

/// Divides the volume into textures. In a series, pieces are numbered from the clip's start, so that only new ones are
/// uploaded.
void cut_into_pieces(const ComposePlan& plan, const Observation& seen, Composition& composed) {
    std::vector<std::int64_t> layers;
    for (const KeyFrame& key : seen.keyframes) layers.push_back(layer_of(key, seen.volume));
    if (plan.look.shows(Part::volume))
        composed.pieces = volume::cut_into_sub_bricks(volume::cut_at(composed.bricks, layers));
    composed.layers = seen.volume.layers();
    auto most = static_cast<int>(composed.pieces.size());
    if (plan.volume.series) {
        const std::int64_t of_brick = plan.volume.window.pieces_of_brick();
        composed.first_piece = seen.first_brick * of_brick;
        composed.layers = plan.volume.window.layers();
        most = plan.volume.window.bricks * static_cast<int>(of_brick);
    }
    composed.textures = plan.volume.textures(most);
}

void add(const std::vector<scene::LineSegment>& lines, scene::Scene& scene) {
    scene.lines.insert(scene.lines.end(), lines.begin(), lines.end());
}

void add_flow(const ComposePlan& plan, const Observation& seen, const Composition& composed, scene::Scene& scene) {
    const volume::Volume& volume = seen.volume;
    const space::Layout& layout = *plan.look.layout;
    const std::vector<volume::FrameSeed> seeds =
        volume::used_seeds(volume, composed.bricks, seen.first_brick, plan.volume.seed_flags);
    if (plan.look.shows(Part::arrows)) scene.arrows = scene::arrows(volume, seeds, layout, plan.look.glyphs);
    if (plan.look.shows(Part::directions)) {
        const double length = 1.5 * plan.look.glyphs.cap;
        const std::vector<scene::Glyph> along = annotation::direction_arrows(composed.objects, volume, layout, length);
        scene.arrows.insert(scene.arrows.end(), along.begin(), along.end());
    }
    if (plan.look.shows(Part::tracelines))
        scene.tracelines = scene::tracelines(volume, seeds, layout, plan.look.traces);
}

void add_lines(const ComposePlan& plan, const Observation& seen, const Composition& composed, scene::Scene& scene) {
    const volume::Volume& volume = seen.volume;
    const space::Layout& layout = *plan.look.layout;
    const scene::Theme& theme = plan.look.theme;
    const annotation::TimeEdge& edge = composed.framing.edge;
    const glm::vec4 colour(theme.lines, 1);
    if (plan.look.shows(Part::outline)) add(scene::volume_outline(layout, colour), scene);
    add(annotation::ruler_marks(volume, layout, edge, composed.ticks, colour), scene);
    if (plan.look.shows(Part::ribs)) {
        // Pale but opaque: the lines hide what is behind them, and so look as if they are inside the volume.
        const glm::vec4 pale = glm::mix(colour, plan.look.picture.background, 0.55F);
        for (const annotation::TimeTick& tick : composed.ticks)
            add(scene::cross_section(layout, volume.t_of_seconds(tick.seconds), pale), scene);
        add(annotation::ruler_marks(volume, layout, {1 - edge.x, edge.y}, composed.ticks, colour), scene);
    }
    if (plan.look.shows(Part::ruler)) {
        add(annotation::break_marks(annotation::time_breaks(volume, breaks_shown), layout, edge, colour), scene);
        add(annotation::gap_marks(annotation::time_gaps(volume), layout, edge, glm::vec4(theme.fast, 1)), scene);
    }
    if (!plan.look.shows(Part::bricks)) return;
    for (const volume::Brick& brick : composed.bricks) {
        const double t = static_cast<double>(brick.first) / static_cast<double>(composed.layers);
        if (t > 0) add(scene::cross_section(layout, t, glm::vec4(theme.lines, 0.5)), scene);
    }
}

/// The frames that are shown in the volume.
std::vector<scene::StandingFrame> standing_frames(const Observation& seen) {
    constexpr float at_the_ends = 0.5F;
    constexpr float between = 0.3F;  // less opaque, as they hide what is behind them
    const volume::Volume& volume = seen.volume;
    std::vector<scene::StandingFrame> frames;
    const auto stand = [&frames](double t, const media::Frame& frame, std::int64_t number, float opacity) {
        Plane<Bgr> picture = media::picture_of(frame);
        if (!picture.empty()) frames.push_back({t, std::move(picture), opacity, static_cast<double>(number)});
    };
    stand(0, *seen.first, 0, at_the_ends);
    for (const KeyFrame& key : seen.keyframes) {
        // The volume's first frame is already shown at its start.
        if (key.number > 0) stand(volume.t_of_layer(layer_of(key, volume)), *key.frame, key.number, between);
    }
    stand(volume.t_end(), *seen.last, volume.frames() - 1, at_the_ends);
    return frames;
}

}  // namespace

scene::Scene scene_of(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    scene::Scene scene;
    const scene::Theme& theme = plan.look.theme;
    add_flow(plan, seen, composed, scene);
    add_lines(plan, seen, composed, scene);
    if (plan.look.shows(Part::floor)) {
        scene.floor = seen.volume.keeps_owners() ? scene::floor_shadow(seen.volume, theme, seen.identify)
                                                 : scene::floor_shadow(seen.volume, theme.shadow);
    }
    if (plan.look.shows(Part::frames)) scene.frames = standing_frames(seen);
    return scene;
}

std::vector<glm::vec4> palette_of(const LookPlan& look) {
    if (look.picture.colour == gl::VolumeColour::object) return scene::object_palette(look.theme);
    return look.picture.colour == gl::VolumeColour::time ? scene::time_colours() : std::vector<glm::vec4>{};
}

Composition compose(const ComposePlan& plan, const Observation& seen) {
    Composition composed;
    composed.framing = plan.look.framing();
    composed.bricks = cut(plan, seen);
    composed.compressed_idle = volume::compressed_stretches(seen.volume);
    composed.nothing_moves = nothing_visible(seen.volume, plan.look.transfer);
    composed.objects = objects_to_show(plan, seen);
    composed.ticks = ticks_of(plan, composed.framing, seen.volume);
    cut_into_pieces(plan, seen, composed);
    composed.palette = palette_of(plan.look);
    // Without objects, show the changes at least.
    if (plan.volume.colours_objects() && !plan.volume.series && composed.objects.events.empty())
        composed.palette.front().a = 1;
    composed.scene = scene_of(plan, seen, composed);
    composed.frames_missing = plan.volume.series && plan.look.shows(Part::frames) && seen.volume.missing() == 0 &&
                              composed.scene.frames.size() < 2;
    composed.boxes = plan.look.shows(Part::boxes);
    if (plan.look.shows(Part::slices)) {
        // Those of the default view: seen from there, they would all be parallel to the picture.
        composed.slices =
            space::fit_camera(space::View{}, scene::outline_points(*plan.look.layout), plan.look.picture.size);
    }
    if (!plan.look.only_page) composed.lettering = annotate(plan, seen, composed);
    return composed;
}

namespace {

/// A clip in which a point moves. As in most clips, its size is no power of two: Mesa compiles different shaders for
/// those.
Observation observe_sample(const ComposePlan& plan) {
    constexpr Size size{6, 6};
    constexpr int frames = 5;
    Observation seen{volume::Volume(size, {.capacity = frames, .keep_owners = plan.volume.colours_objects()})};
    const bool coloured = plan.volume.colour->drawn == gl::VolumeColour::own;
    for (int i = 0; i < frames; ++i) {
        fields::Field field{i, i / 25.0, Plane<std::uint8_t>(size), {}, {{2, 2, 1, 1}}};
        field.scalar.at(2, 2) = 255;
        seen.volume.add(field, coloured ? Plane<Bgr>(size) : Plane<Bgr>());
    }
    seen.first = seen.last = std::make_shared<const media::Frame>(media::Frame{0, 0, Plane<std::uint8_t>(size), {}});
    return seen;
}

}  // namespace

Sample compose_sample(const ComposePlan& plan) {
    Sample sample{observe_sample(plan), {}};
    Composition& composed = sample.composed;
    composed.framing = plan.look.framing();
    composed.layers = sample.seen.volume.layers();
    if (plan.look.shows(Part::volume)) composed.pieces = volume::cut_into(composed.layers, 1);
    composed.scene = scene_of(plan, sample.seen, composed);
    return sample;
}

}  // namespace vvr::app
