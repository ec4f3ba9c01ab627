#include <memory>

#include <fmt/format.h>
#include <oneapi/tbb/enumerable_thread_specific.h>

#include "core/error.h"
#include "core/fields/filter.h"
#include "core/fields/pipeline.h"
#include "core/video/scaler.h"

namespace vvr {
namespace {

// An odd number, so that the median is the middle value; a passer-by has to stand still for half of the clip to stay
// in it.
constexpr int frames_for_median = 31;

Reference picture_reference(const std::string& name, const FrameSource& clip) {
    SourceOptions options;
    options.field_size = clip.field_size();
    options.colour = clip.colour();
    const auto picture = open_source(name, options);
    Frame frame = Scaler(*picture)(*picture->next());
    return {std::move(frame.grey), std::move(frame.colour)};
}

Reference make_reference(FrameSource& clip, const FieldOptions& options) {
    if (!find_filter(options.filter).needs.reference) return {};
    if (options.reference == "median") return median_reference(clip.sample(frames_for_median));
    return picture_reference(options.reference, clip);
}

}  // namespace

FieldSummary compute_fields(FrameSource& source, const FieldOptions& options, const FieldSink& sink) {
    FieldSummary summary;
    summary.reference = make_reference(source, options);
    oneapi::tbb::enumerable_thread_specific<Scaler> scalers([&] { return Scaler(source); });
    const FrameReader read = [&]() -> FrameJob {
        std::shared_ptr<DecodedFrame> decoded = source.next();
        if (!decoded) return {};
        return [&scalers, decoded] { return scalers.local()(*decoded); };
    };
    summary.frames = compute_fields(read, summary.reference, options, sink);
    summary.damaged = source.damaged();
    if (summary.frames == 0) {
        throw Error(ErrorKind::not_video,
                    fmt::format("{}: not one frame could be decoded; is it video?", source.info().name));
    }
    return summary;
}

}  // namespace vvr
