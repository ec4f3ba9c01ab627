#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/condition/condition_finder.h"
#include "core/fields/field.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/object.h"
#include "core/fields/options.h"
#include "core/fields/reference.h"
#include "core/fields/stabilizer.h"

namespace vvr::fields {

/// A frame in the pipeline. The frames before and after it read it too, so nothing may be moved out of it.
struct PipelineFrame {
    media::SharedFrame frame;                            ///< aligned with the reference if the camera shakes
    std::shared_ptr<const media::DecodedFrame> decoded;  ///< the frame's picture in full size, if kept
    std::optional<VisibleArea> visible;  ///< the part of the reference that it shows, if the camera shakes
    Planes smooth;
    Plane<std::uint8_t> object;        ///< the difference object, if needed
    Plane<std::uint8_t> darker;        ///< as FoundObject::darker
    std::size_t view = 0;              ///< as Field::view
    double other_light = 0;            ///< as Field::other_light
    double middle_grey = 0;            ///< as FoundObject::middle_grey
    condition::FrameSigns signs{};     ///< empty if it is compared with no empty scene
    condition::Agreement agreement{};  ///< with the view of its empty scene
    condition::Verdict verdict{};
    condition::Kind before{};               ///< as Field::before
    std::shared_ptr<const NewScene> scene;  ///< as Field::scene
    Quantiles levels{};                     ///< of the frame's grey; they show jumps of the light
    Plane<std::uint8_t> foreground;         ///< output of a filter that needs the frames in order
    Plane<std::uint8_t> second;             ///< output of the second filter
    Plane<std::uint16_t> age;               ///< number of frames for which each pixel has been part of an object
    FlowFrame flow_frame;                   ///< made by the first neighbour that needs it
    std::once_flag flow_frame_made;
};

/// A frame with its neighbours on both sides; null beyond the clip's ends.
using Neighbourhood = std::vector<std::shared_ptr<PipelineFrame>>;

/// Computes a frame's field in three steps: `begin`, `gather`, `finish`.
class FieldStages {
  public:
    FieldStages(const EmptyScene& scene, const FieldOptions& options);
    ~FieldStages() = default;
    FieldStages(const FieldStages&) = delete;
    FieldStages& operator=(const FieldStages&) = delete;

    /// The number of frames on each side that a field depends on.
    int reach() const { return reach_; }

    /// Whether a field depends on all frames before it.
    bool is_stateful() const { return stateful_; }

    /// Runs the steps that need this frame alone. Thread-safe.
    std::shared_ptr<PipelineFrame> begin(media::Frame frame) const;

    /// Runs the steps that need the frames in order, one call at a time.
    /// \param shot null after the last frame
    /// \returns the neighbourhood of the frame `reach` steps before
    Neighbourhood gather(std::shared_ptr<PipelineFrame> shot);

    /// Runs the steps that need the neighbours. Thread-safe; filters that need the frames in order have run in
    /// `gather`.
    Field finish(const Neighbourhood& neighbours) const;

  private:
    /// What is known of an empty scene.
    struct SceneStage {
        std::unique_ptr<ObjectFinder> object;    ///< null if the difference object isn't needed
        std::unique_ptr<Stabilizer> stabilizer;  ///< null unless the camera shakes
        condition::EdgeMap edges;
        bool infrared = false;
    };

    SceneStage stage_of(const Reference& scene) const;
    std::size_t view_of(const media::Frame& frame, const condition::EdgeMap& edges) const;
    void judge(PipelineFrame& shot);
    std::shared_ptr<PipelineFrame> compared(media::Frame frame, condition::FrameSigns signs,
                                            const SceneStage& scene) const;
    static void store_object(PipelineFrame& shot, FoundObject&& found);
    /// A filter and its parameters.
    struct ActiveFilter {
        const FilterRow* row;
        Filter filter;
        int threshold;
    };

    static ActiveFilter activate(const FilterRow& row, const FieldOptions& options, std::optional<int> threshold);
    Plane<std::uint8_t> filtered(const ActiveFilter& filter, const PipelineFrame& shot, const PipelineFrame* before,
                                 const Flow& flow) const;
    Flow flow_of(const Neighbourhood& neighbours, const Plane<std::uint8_t>& moves) const;
    const FlowFrame& prepared(PipelineFrame& shot) const;
    Plane<std::uint8_t> moving(const Neighbourhood& neighbours, const Plane<std::uint8_t>& object) const;

    FieldOptions options_;
    ActiveFilter first_;
    std::optional<ActiveFilter> second_;
    const FilterRow& row_;  ///< row of the first filter
    Plane<std::uint8_t> region_;
    std::unique_ptr<FlowMethod> flow_;
    bool whole_frame_flow_;
    std::vector<SceneStage> scenes_;  ///< of the camera's views, as Reference::of_view
    condition::ConditionFinder condition_;
    condition::LightFinder light_;
    bool needs_age_ = false;
    bool stateful_ = false;
    bool withheld_ = false;               ///< the last gathered frame shows nothing of the scene
    std::size_t view_ = 0;                ///< of the last frame that shows its scene
    std::optional<double> edges_made_{};  ///< seconds; when those of an adapting scene were made
    int reach_ = 0;
    std::deque<std::shared_ptr<PipelineFrame>> last_;  ///< the last 2 reach + 1 gathered frames
};

}  // namespace vvr::fields
