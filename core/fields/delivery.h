#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/condition/condition_finder.h"
#include "core/fields/field.h"

namespace vvr::fields {

/// A frame at the end of the pipeline.
struct PipelineResult {
    media::SharedFrame frame;
    Field field;  ///< without values where the condition is not normal
    condition::Verdict verdict{};
    std::shared_ptr<const media::DecodedFrame> decoded{};  ///< while the sink runs
};

/// Hands fields over in order, without those of frames that show nothing of the scene; the next field says why they are
/// missing. Of a clip's first and last frame, an empty field is handed over then, so that its times stay as they are.
/// Frames that repeat the one before wait until it is known whether the recording is frozen.
class FieldDelivery {
  public:
    explicit FieldDelivery(const FieldSink& sink) : sink_(sink) {}

    void operator()(PipelineResult result);

    /// Call it after the last frame.
    void finish();

    /// Fields handed over so far.
    std::int64_t frames() const { return frames_; }

  private:
    void release_waiting();
    void withhold(PipelineResult result);
    void hand_over(PipelineResult result);

    const FieldSink& sink_;
    std::vector<PipelineResult> waiting_;     ///< they repeat the one before
    std::optional<PipelineResult> withheld_;  ///< the last one that was not handed over, since the last that was
    std::int64_t frames_ = 0;
};

}  // namespace vvr::fields
