#include "core/page/watched_fields.h"

#include <algorithm>
#include <utility>

#include "core/fit_into.h"

namespace vvr {

namespace {

constexpr int still_side = 240;

}  // namespace

WatchedFields::WatchedFields(std::unique_ptr<FieldSource> fields) : fields_(std::move(fields)) {}

FieldSummary WatchedFields::read(const FieldNeeds& needs, const FieldSink& sink) {
    begin();
    FieldNeeds more = needs;
    more.colour = needs.colour || has_pictures();
    return fields_->read(more, [&](const SharedFrame& frame, Field&& field) {
        look_at(*frame, field);
        sink(frame, std::move(field));
    });
}

Moments WatchedFields::take() {
    Moments moments{times_.stretches(), {}, {}};
    if (stills_) moments.stills = stills_->take();
    if (preview_) moments.preview = preview_->finish();
    return moments;
}

void WatchedFields::begin() {
    ExpectedLength expected{expected_frames(), 0};
    if (info().rate > 0) expected.seconds = static_cast<double>(expected.frames) / info().rate;
    times_ = {};
    stills_.emplace(fit_into(info().size, still_side));
    preview_.reset();
    // With pictures of only two frames, a film is of no use.
    if (has_pictures()) preview_.emplace(fit_into(info().size, Preview::long_side), expected);
}

void WatchedFields::look_at(const Frame& frame, const Field& field) {
    times_.add(field.index, field.pts);
    const Plane<Bgr> picture = picture_of(frame);
    if (picture.empty()) return;
    const auto quiet = std::ranges::count(field.scalar.pixels(), std::uint8_t{0});
    stills_->add(field.index, field.pts, picture, std::ssize(field.scalar.pixels()) - quiet);
    if (preview_) preview_->add(field.index, field.pts, picture);
}

}  // namespace vvr
