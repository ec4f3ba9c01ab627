#include "core/fields/field_stages.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <opencv2/core.hpp>

#include "core/base/cv_view.h"
#include "core/fields/blobs.h"
#include "core/fields/object.h"
#include "core/fields/seeds.h"
#include "core/fields/thresholds.h"
#include "core/fields/views.h"

namespace vvr::fields {
namespace {

void paste(const Flow& part, const PixelBox& where, Flow& whole) {
    for (int j = 0; j < where.height(); ++j) {
        std::ranges::copy(part.u.row(j), whole.u.row(where.top + j).begin() + where.left);
        std::ranges::copy(part.v.row(j), whole.v.row(where.top + j).begin() + where.left);
    }
}

/// Whether there is neither a gap nor a jump of the light between two frames.
bool continuous(const PipelineFrame& a, const PipelineFrame& b) {
    return std::abs(a.frame->index - b.frame->index) == 1 && a.view == b.view &&
           !illumination_jumps(a.levels, b.levels);
}

/// The neighbourhood without frames beyond a gap or a jump of the light: flow methods assume constant brightness.
Neighbourhood continuous_part(Neighbourhood neighbours, int reach) {
    for (const int step : {-1, 1}) {
        const PipelineFrame* inner = neighbours[static_cast<std::size_t>(reach)].get();
        for (int k = 1; k <= reach; ++k) {
            std::shared_ptr<PipelineFrame>& shot = neighbours[static_cast<std::size_t>(reach + step * k)];
            if (shot == nullptr || inner == nullptr || !continuous(*shot, *inner)) shot = nullptr;
            inner = shot.get();
        }
    }
    return neighbours;
}

}  // namespace

FieldStages::FieldStages(const EmptyScene& scene, const FieldOptions& options)
    : options_(options),
      first_(activate(*options.filter, options, options.threshold)),
      row_(*first_.row),
      region_(scene.region),
      flow_(make_flow(options.flow)),
      whole_frame_flow_(is_short(scene.frames) || !options.seeds.area->object_alone ||
                        options.flow.method.is_folder()) {
    if (options.second != nullptr) second_.emplace(activate(*options.second, options, std::nullopt));
    const FilterTraits second_traits = second_ ? second_->row->traits : FilterTraits{};
    for (std::size_t view = 0; view <= scene.reference.others.size(); ++view)
        scenes_.push_back(stage_of(scene.reference.of_view(view)));
    needs_age_ = flow_ != nullptr && options.seeds.order->needs_age;
    stateful_ = row_.traits.in_order || second_traits.in_order || needs_age_ ||
                (scenes_.front().object != nullptr && scenes_.front().object->adapts());
    reach_ = std::max(flow_ ? flow_->reach() : 0, row_.traits.previous || second_traits.previous ? 1 : 0);
    last_.resize(static_cast<std::size_t>(2 * reach_ + 1));
}

FieldStages::SceneStage FieldStages::stage_of(const Reference& scene) const {
    SceneStage stage;
    stage.infrared = scene.infrared;
    if (needs_reference(options_)) {
        const int threshold =
            row_.traits.object ? options_.threshold.value_or(row_.traits.threshold) : thresholds.object.usual;
        const bool darker = row_.traits.darker || (second_ && second_->row->traits.darker);
        stage.object = std::make_unique<ObjectFinder>(options_, threshold, scene, region_, darker);
        if (scene.is_view) stage.edges = condition::edge_map(scene.grey);
    }
    if (scene.shakes) stage.stabilizer = std::make_unique<Stabilizer>(scene);
    return stage;
}

std::shared_ptr<PipelineFrame> FieldStages::begin(media::Frame frame) const {
    condition::FrameSigns signs;
    if (row_.traits.object) signs = condition::signs_of(frame.grey);
    const std::size_t view = scenes_.size() > 1 ? view_of(frame, signs.edges) : 0;
    std::shared_ptr<PipelineFrame> shot = compared(std::move(frame), std::move(signs), scenes_[view]);
    shot->view = view;
    if (flow_) shot->levels = quantiles_of(shot->frame->grey);
    return shot;
}

/// The view that a frame shows best; a camera's modes can show the same.
std::size_t FieldStages::view_of(const media::Frame& frame, const condition::EdgeMap& edges) const {
    const bool infrared = shows_infrared(frame);
    const auto fits = [&](const SceneStage& scene) {
        return condition::agreement(edges, scene.edges).share + (scene.infrared == infrared ? 1 : 0);
    };
    return static_cast<std::size_t>(std::ranges::max_element(scenes_, {}, fits) - scenes_.begin());
}

std::shared_ptr<PipelineFrame> FieldStages::compared(media::Frame frame, condition::FrameSigns signs,
                                                     const SceneStage& scene) const {
    auto shot = std::make_shared<PipelineFrame>();
    if (scene.stabilizer) shot->visible = scene.stabilizer->align(frame, scene.stabilizer->shift_of(frame.grey));
    shot->frame = std::make_shared<const media::Frame>(std::move(frame));
    shot->smooth = smoothed(shot->frame->grey, shot->frame->colour, options_.smooth);
    shot->signs = std::move(signs);
    if (!scene.object) return shot;
    if (scene.stabilizer && row_.traits.object) {
        shot->signs.edges = condition::edge_map(shot->frame->grey);
        shot->signs.samples.clear();  // a camera that stops shaking is not frozen
    }
    if (scene.object->adapts()) return shot;
    shot->agreement = condition::agreement(shot->signs.edges, scene.edges);
    store_object(*shot, scene.object->find(shot->smooth));
    return shot;
}

void FieldStages::store_object(PipelineFrame& shot, FoundObject&& found) {
    shot.object = std::move(found.values);
    shot.darker = std::move(found.darker);
    shot.other_light = found.other_light;
    shot.middle_grey = found.middle_grey;
    if (shot.visible) clear_outside_overlap(*shot.visible, shot.object);
}

Neighbourhood FieldStages::gather(std::shared_ptr<PipelineFrame> shot) {
    if (shot) {
        judge(*shot);
        if (row_.traits.in_order) shot->foreground = filtered(first_, *shot, nullptr, {});
        if (second_ && second_->row->traits.in_order) shot->second = filtered(*second_, *shot, nullptr, {});
        if (needs_age_) {
            const PipelineFrame* const before = last_.back().get();
            shot->age = aged(before ? before->age : Plane<std::uint16_t>{},
                             row_.traits.in_order ? shot->foreground : shot->object);
        }
    }
    last_.pop_front();
    last_.push_back(std::move(shot));
    return {last_.begin(), last_.end()};
}

/// Tells the condition of the next frame. A reference that adapts does so only to frames that show something new.
void FieldStages::judge(PipelineFrame& shot) {
    shot.before = shot.frame->before;
    SceneStage& scene = scenes_[shot.view];
    if (!scene.object) return;
    const double now = shot.frame->pts;
    const std::size_t before = view_;
    const bool adapts = scene.object->adapts();
    if (adapts) shot.agreement = condition::agreement(shot.signs.edges, scene.edges);
    // Filters that show the video itself or its motion show the camera's too.
    if (row_.traits.object) shot.verdict = condition_(shot.signs, shot.agreement, now);
    using condition::Kind;
    const bool turned = shot.verdict.kind == Kind::turning;
    if (adapts && (turned || shot.verdict.kind == Kind::normal)) {
        FoundObject found = scene.object->find_and_adapt(shot.smooth, now, turned);
        if (found.learning) shot.verdict = {Kind::unlearnt};
        if (found.scene) shot.verdict = {};
        shot.scene = found.scene;
        store_object(shot, std::move(found));
        if (shot.scene || !edges_made_ || now - *edges_made_ >= 1) {
            scene.edges = condition::edge_map(scene.object->adapted().grey);
            edges_made_ = now;
        }
    }
    const bool was_withheld = std::exchange(withheld_, shot.verdict.kind != Kind::normal);
    if (withheld_) return;
    if (shot.view != view_ || shot.scene) light_ = {};
    if (light_(shot.middle_grey, now) && shows(shot.agreement)) shot.other_light = 1;
    const bool infrared = scenes_[std::exchange(view_, shot.view)].infrared;
    if (view_ == before) return;
    shot.before = infrared != scene.infrared ? Kind::infrared : was_withheld ? Kind::turning : Kind::moved;
}

Field FieldStages::finish(const Neighbourhood& neighbours) const {
    const auto middle = static_cast<std::size_t>(reach_);
    const PipelineFrame& here = *neighbours[middle];
    const PipelineFrame* const before = reach_ > 0 ? neighbours[middle - 1].get() : nullptr;
    const FilterTraits& traits = row_.traits;
    Field field;
    field.index = here.frame->index;
    field.pts = here.frame->pts;
    field.view = here.view;
    field.before = here.before;
    field.other_light = here.other_light;
    field.scene = here.scene;
    if (here.verdict.kind != condition::Kind::normal) return field;
    field.scalar = traits.in_order ? here.foreground : filtered(first_, here, before, {});
    const FilterTraits second_traits = second_ ? second_->row->traits : FilterTraits{};
    if (second_) field.second = second_traits.in_order ? here.second : filtered(*second_, here, before, {});
    const bool requested = here.frame->index % options_.flow.every == 0;
    if (!flow_ || (!requested && !traits.flow && !second_traits.flow && !options_.flow.every_frame)) return field;

    const Neighbourhood connected = continuous_part(neighbours, reach_);
    // If the filter needs the difference object, that is used: the filter's values may also mark uncovered pixels,
    // which are no object.
    const Plane<std::uint8_t> moves = moving(connected, scenes_.front().object ? here.object : field.scalar);
    field.flow = flow_of(connected, moves);
    if (requested) field.seeds = make_seeds({here.frame->index, field.flow, moves, here.age}, options_.seeds);
    if (traits.flow) field.scalar = filtered(first_, here, before, field.flow);
    if (second_traits.flow) field.second = filtered(*second_, here, before, field.flow);
    return field;
}

FieldStages::ActiveFilter FieldStages::activate(const FilterRow& row, const FieldOptions& options,
                                                std::optional<int> threshold) {
    return {&row, row.make(options), threshold.value_or(row.traits.threshold)};
}

Plane<std::uint8_t> FieldStages::filtered(const ActiveFilter& filter, const PipelineFrame& shot,
                                          const PipelineFrame* before, const Flow& flow) const {
    const FilterTraits& traits = filter.row->traits;
    Plane<std::uint8_t> scalar = filter.filter({.frame = *shot.frame,
                                                .smooth = shot.smooth,
                                                .previous = before ? &before->smooth : nullptr,
                                                .object = shot.object,
                                                .previous_object = before ? &before->object : nullptr,
                                                .darker = shot.darker,
                                                .flow = flow});
    // The difference object and all that is made of it are clean already.
    if (!traits.object) {
        clean(scalar,
              {.threshold = filter.threshold, .gain = traits.gain, .min_area = traits.min_area ? options_.min_area : 0},
              region_);
    }
    return scalar;
}

// Flow is computed only around visible pixels that change, with the method's margin. Beyond an end of the clip or a
// jump of the light, the last frame is repeated.
Flow FieldStages::flow_of(const Neighbourhood& neighbours, const Plane<std::uint8_t>& moves) const {
    const PipelineFrame& here = *neighbours[static_cast<std::size_t>(reach_)];
    const Size size = here.frame->grey.size();
    Flow flow{Plane<float>(size), Plane<float>(size)};
    const bool everywhere = whole_frame_flow_ || row_.traits.flow || (second_ && second_->row->traits.flow);
    const std::vector<PixelBox> parts =
        everywhere ? std::vector<PixelBox>{{0, 0, size.width, size.height}} : regions_around(moves, flow_->margin());
    if (parts.empty()) return flow;
    const int reach = flow_->reach();
    std::vector<const FlowFrame*> frames(static_cast<std::size_t>(2 * reach + 1));
    for (const int step : {-1, 1}) {
        PipelineFrame* nearest = nullptr;
        for (int k = 0; k <= reach; ++k) {
            PipelineFrame* const shot = neighbours[static_cast<std::size_t>(reach_ + step * k)].get();
            if (shot != nullptr) nearest = shot;
            frames[static_cast<std::size_t>(reach + step * k)] = &prepared(*nearest);
        }
    }
    for (const PixelBox& part : parts) paste((*flow_)(frames, part), part, flow);
    return flow;
}

// The part of the object that changes from the previous frame or to the next; noise in the rest would look like motion.
Plane<std::uint8_t> FieldStages::moving(const Neighbourhood& neighbours, const Plane<std::uint8_t>& object) const {
    const auto middle = static_cast<std::size_t>(reach_);
    const PipelineFrame& here = *neighbours[middle];
    Plane<std::uint8_t> result(object.size());
    for (const std::size_t k : {middle - 1, middle + 1}) {
        if (reach_ == 0 || neighbours[k] == nullptr) continue;
        mark_changes(neighbours[k]->smooth.grey, here.smooth.grey, object, result);
    }
    return result;
}

const FlowFrame& FieldStages::prepared(PipelineFrame& shot) const {
    std::call_once(shot.flow_frame_made, [&] {
        shot.flow_frame = flow_->prepare(shot.frame->grey);
        shot.flow_frame.index = shot.frame->index;
    });
    return shot.flow_frame;
}

}  // namespace vvr::fields
