#include "core/fields/clip_reader.h"

#include <utility>

namespace vvr {

ClipReader::ClipReader(FrameSource& source, const FieldOptions& options, int context, bool from_first)
    : source_(source),
      start_(options.start),
      end_(options.end),
      context_(static_cast<std::size_t>(context)),
      started_(from_first),
      scalers_([&source] { return Scaler(source); }) {}

// Until the first frame that counts, only the last few are kept, and not yet scaled.
std::shared_ptr<DecodedFrame> ClipReader::next() {
    while (!started_) {
        std::shared_ptr<DecodedFrame> decoded = source_.next();
        if (!decoded) break;
        started_ = decoded->pts >= start_;
        waiting_.push_back(std::move(decoded));
        if (!started_ && waiting_.size() > context_) waiting_.pop_front();
    }
    if (!started_) return nullptr;
    if (waiting_.empty()) return source_.next();
    std::shared_ptr<DecodedFrame> first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
}

FrameJob ClipReader::operator()() {
    std::shared_ptr<DecodedFrame> decoded = next();
    if (!decoded) return {};
    if (end_ && decoded->pts >= *end_ && past_end_++ == context_) return {};
    return [this, decoded] { return scalers_.local()(*decoded); };
}

}  // namespace vvr
