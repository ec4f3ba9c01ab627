#include "core/page/moments.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/plane.h"
#include "core/image/picture.h"

namespace vvr::page {

void Timeline::add(std::int64_t frame, double seconds) {
    ++frames_;
    if (count_ == 0 || frame != first_ + count_) {
        begin(frame, seconds);
        return;
    }
    const auto steps = static_cast<double>(count_);
    const double least = std::max(least_, (seconds - tolerance - begin_) / steps);
    const double most = std::min(most_, (seconds + tolerance - begin_) / steps);
    if (least > most) {
        begin(frame, seconds);
        return;
    }
    least_ = least;
    most_ = most;
    ++count_;
}

std::vector<ConstantRateFrames> Timeline::stretches() const {
    std::vector<ConstantRateFrames> all = done_;
    if (count_ > 0) all.push_back(current());
    return all;
}

void Timeline::begin(std::int64_t frame, double seconds) {
    if (count_ > 0) done_.push_back(current());
    first_ = frame;
    count_ = 1;
    begin_ = seconds;
    least_ = 0;
    most_ = std::numeric_limits<double>::infinity();
}

ConstantRateFrames Timeline::current() const {
    return {first_, count_, begin_, count_ > 1 ? (least_ + most_) / 2 : 0};
}

namespace {

constexpr int still_side = 240;
constexpr int small_still_side = 200;
constexpr std::size_t few_stills =
    Stills::most / 2;  // with a preview, a still is shown only until the preview has loaded

/// Whether all current browsers play such a file.
bool browsers_play(const video::VideoInfo& info) {
    const auto is_one_of = [](const std::string& name, std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, name) != names.end();
    };
    return (is_one_of(info.container, {"mp4", "mov"}) && is_one_of(info.codec, {"h264", "av1"})) ||
           (info.container == "webm" && is_one_of(info.codec, {"vp8", "vp9", "av1"}));
}

}  // namespace

WatchedFields::WatchedFields(std::unique_ptr<fields::FieldSource> fields, bool with_preview)
    : fields_(std::move(fields)), with_preview_(with_preview) {}

fields::FieldSummary WatchedFields::read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) {
    begin();
    fields::FieldNeeds more = needs;
    more.colour = needs.colour || has_pictures();
    return fields_->read(more, [&](const video::SharedFrame& frame, fields::Field&& field) {
        look_at(*frame, field);
        sink(frame, std::move(field));
    });
}

Moments WatchedFields::take() {
    if (encoding_.valid()) encoding_.get();
    Moments moments{times_.stretches(), {}, {}, {}};
    if (stills_) moments.stills = stills_->take();
    if (preview_) moments.preview = preview_->finish();
    if (preview_) moments.problem = preview_->problem();
    return moments;
}

void WatchedFields::begin() {
    if (encoding_.valid()) encoding_.get();
    ExpectedLength expected{expected_frames(), 0};
    if (info().rate > 0) expected.seconds = static_cast<double>(expected.frames) / info().rate;
    times_ = {};
    preview_.reset();
    // A preview of two frames would be useless.
    if (has_pictures() && with_preview_) {
        const Preview::Use use = browsers_play(info()) ? Preview::Use::fallback : Preview::Use::instead;
        preview_.emplace(info().size, expected, use);
    }
    const bool has_film = preview_ && preview_->is_possible();
    stills_.emplace(fit_into(info().size, has_film ? small_still_side : still_side),
                    has_film ? few_stills : Stills::most);
}

void WatchedFields::look_at(const video::Frame& frame, const fields::Field& field) {
    times_.add(field.index, field.pts);
    Plane<Bgr> picture = video::picture_of(frame);
    if (picture.empty()) return;
    const auto quiet = std::ranges::count(field.scalar.pixels(), std::uint8_t{0});
    stills_->add(field.index, field.pts, picture, std::ssize(field.scalar.pixels()) - quiet);
    if (preview_) encode(field, std::move(picture));
}

void WatchedFields::encode(const fields::Field& field, Plane<Bgr>&& picture) {
    if (encoding_.valid()) encoding_.get();
    encoding_ = std::async(std::launch::async, [this, index = field.index, pts = field.pts,
                                                shown = std::move(picture)] { preview_->add(index, pts, shown); });
}

namespace {

constexpr int recent_still_side = 200;
constexpr std::int64_t most_stills = 40;  // live pages are sent often, so they must be small

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
    stills_.push_back({field.index, field.pts, image::resized(picture, fit_into(info().size, recent_still_side))});
}

}  // namespace vvr::page
