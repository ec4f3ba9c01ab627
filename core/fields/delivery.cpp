#include "core/fields/delivery.h"

#include <utility>

namespace vvr::fields {

void FieldDelivery::operator()(PipelineResult result) {
    if (result.verdict.kind == condition::Kind::normal && result.verdict.repeats) {
        result.decoded.reset();
        waiting_.push_back(std::move(result));
        return;
    }
    if (result.verdict.kind == condition::Kind::frozen) {
        waiting_.clear();
    } else {
        release_waiting();
    }
    if (result.verdict.kind == condition::Kind::normal) {
        hand_over(std::move(result));
    } else {
        withhold(std::move(result));
    }
}

void FieldDelivery::finish() {
    release_waiting();
    if (withheld_) hand_over(*std::exchange(withheld_, {}));
}

void FieldDelivery::release_waiting() {
    for (PipelineResult& result : std::exchange(waiting_, {})) hand_over(std::move(result));
}

void FieldDelivery::withhold(PipelineResult result) {
    result.decoded.reset();
    result.field.scalar = Plane<std::uint8_t>(result.frame->grey.size());
    if (frames_ == 0) {
        hand_over(std::move(result));
    } else {
        withheld_ = std::move(result);
    }
}

void FieldDelivery::hand_over(PipelineResult result) {
    Field& field = result.field;
    if (withheld_ && field.before == condition::Kind::no_signal) field.before = withheld_->verdict.kind;
    if (withheld_ && withheld_->verdict.kind == condition::Kind::frozen) field.absent_since = withheld_->verdict.since;
    if (result.verdict.kind != condition::Kind::normal && frames_ > 0) field.before = result.verdict.kind;
    withheld_.reset();
    ++frames_;
    sink_(result.frame, std::move(field));
}

}  // namespace vvr::fields
