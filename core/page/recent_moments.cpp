#include "core/page/recent_moments.h"

#include <algorithm>
#include <utility>

#include "core/base/fit_into.h"
#include "core/image/resized.h"

namespace vvr::page {

namespace {

constexpr int still_side = 200;
constexpr std::int64_t most_stills = 40;  // a page that is sent again and again is small

}  // namespace

RecentMoments::RecentMoments(std::unique_ptr<fields::FieldSource> fields, std::int64_t frames)
    : fields_(std::move(fields)), frames_(std::max<std::int64_t>(1, frames)) {}

fields::FieldSummary RecentMoments::read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) {
    times_.clear();
    stills_.clear();
    fields::FieldNeeds more = needs;
    more.colour = needs.colour || has_pictures();
    return fields_->read(more, [&](const video::SharedFrame& frame, fields::Field&& field) {
        look_at(*frame, field);
        sink(frame, std::move(field));
    });
}

Moments RecentMoments::since(std::int64_t first, std::int64_t last) const {
    Timeline times;
    for (const Moment& moment : times_) {
        if (moment.frame >= first && moment.frame <= last) times.add(moment.frame, moment.seconds);
    }
    Moments moments{times.stretches(), {}, {}};
    std::ranges::copy_if(stills_, std::back_inserter(moments.stills),
                         [=](const Still& still) { return still.frame >= first && still.frame <= last; });
    if (moments.stills.empty() && !stills_.empty()) moments.stills.push_back(stills_.back());
    return moments;
}

void RecentMoments::look_at(const video::Frame& frame, const fields::Field& field) {
    times_.push_back({field.index, field.pts});
    if (std::ssize(times_) > frames_) times_.pop_front();
    while (!stills_.empty() && stills_.front().frame < times_.front().frame) stills_.pop_front();
    const std::int64_t apart = std::max<std::int64_t>(1, frames_ / most_stills);
    if (!stills_.empty() && field.index - stills_.back().frame < apart) return;
    const Plane<Bgr> picture = video::picture_of(frame);
    if (picture.empty()) return;
    stills_.push_back({field.index, field.pts, image::resized(picture, fit_into(info().size, still_side))});
}

}  // namespace vvr::page
