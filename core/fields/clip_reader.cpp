#include "core/fields/clip_reader.h"

#include <algorithm>
#include <utility>

namespace vvr::fields {

ClipReader::ClipReader(video::FrameSource& source, const video::FrameSpan& span, int context, bool from_first)
    : source_(source),
      span_(span),
      context_(static_cast<std::size_t>(context)),
      from_first_(from_first),
      scalers_([&source] { return video::Scaler(source); }) {}

std::shared_ptr<video::DecodedFrame> ClipReader::read() {
    std::shared_ptr<video::DecodedFrame> frame = source_.next();
    if (frame) {
        last_index_ = frame->index;
        last_pts_ = frame->pts;
    }
    return frame;
}

/// Reads up to the first frame of the span and keeps the last few before it, not yet scaled.
void ClipReader::collect_context() {
    waiting_.clear();
    while (auto frame = read()) {
        const bool counts = !video::is_before(span_, frame->index, frame->pts);
        waiting_.push_back(std::move(frame));
        if (counts) return;
        if (waiting_.size() > context_) waiting_.pop_front();
    }
    waiting_.clear();
}

void ClipReader::seek_to_span() {
    if (from_first_ || span_ == video::FrameSpan{}) return;
    const double rate = source_.info().rate;
    if (rate > 0) {
        const double start = std::max(span_.start, static_cast<double>(span_.first) / rate);
        source_.seek(start - (static_cast<double>(context_) + 2) / rate);
    }
    collect_context();
    const bool whole = waiting_.size() > context_ || (!waiting_.empty() && waiting_.front()->index == 0);
    if (rate <= 0 || whole) return;
    // Where frames come at uneven times, the place that the rate gave can be too late.
    source_.rewind();
    collect_context();
}

FrameJob ClipReader::operator()() {
    if (!std::exchange(begun_, true)) seek_to_span();
    std::shared_ptr<video::DecodedFrame> decoded;
    if (waiting_.empty()) {
        decoded = read();
    } else {
        decoded = std::move(waiting_.front());
        waiting_.pop_front();
    }
    if (!decoded) return {};
    if (video::is_past(span_, decoded->index, decoded->pts) && past_end_++ == context_) return {};
    return [this, decoded] { return scalers_.local()(*decoded); };
}

}  // namespace vvr::fields
