#include "core/page/moments.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/image/picture.h"

namespace vvr::page {

namespace {

/// The frame that shows an event best. What was taken is seen until it goes.
std::int64_t best_frame(const tracking::Event& event) {
    if (event.portrait) return event.portrait->at.frame;
    return row_of(event.kind).is_of_scene ? event.first.frame : (event.first.frame + event.last.frame) / 2;
}

/// A key to rank events; more informative events are greater.
auto worth(const tracking::Event& event) {
    return std::tuple(-row_of(event.kind).rank, tracking::stationary_seconds(event),
                      event.last.seconds - event.first.seconds);
}

const Still& nearest_to(std::span<const Still> stills, std::int64_t frame) {
    return *std::ranges::min_element(stills, {}, [frame](const Still& still) { return std::abs(still.frame - frame); });
}

}  // namespace

std::optional<Still> best_still(std::span<const Still> stills, std::span<const tracking::Event> events) {
    if (stills.empty()) return std::nullopt;
    const auto event = std::ranges::max_element(events, {}, worth);
    if (event == events.end()) return stills[stills.size() / 2];
    return nearest_to(stills, best_frame(*event));
}

namespace {

constexpr int sheet_side = 240;

/// The stills that a contact sheet shows, in order of time.
std::vector<const Still*> sheet_stills(std::span<const Still> stills, std::span<const tracking::Event> events) {
    std::set<const Still*> chosen;
    for (const tracking::Event& event : events) {
        chosen.insert(&nearest_to(stills, (event.first.frame + event.last.frame) / 2));
        for (const Still& still : stills) {
            if (still.frame >= event.first.frame && still.frame <= event.last.frame) chosen.insert(&still);
        }
    }
    if (chosen.empty()) chosen.insert(&stills[stills.size() / 2]);
    std::vector<const Still*> shown;  // the order of addresses is that of time
    const std::size_t count = std::min(chosen.size(), ContactSheet::most);
    const std::vector<const Still*> all(chosen.begin(), chosen.end());
    for (std::size_t k = 0; k < count; ++k) shown.push_back(all[(2 * k + 1) * all.size() / (2 * count)]);
    return shown;
}

}  // namespace

std::optional<ContactSheet> contact_sheet(std::span<const Still> stills, std::span<const tracking::Event> events) {
    if (stills.empty()) return std::nullopt;
    const std::vector<const Still*> shown = sheet_stills(stills, events);
    const Size tile = fit_into(stills.front().picture.size(), sheet_side);
    const int count = static_cast<int>(shown.size());
    const int columns = std::min(count, ContactSheet::columns);
    ContactSheet sheet{Plane<Bgr>({columns * tile.width, (count + columns - 1) / columns * tile.height}), {}};
    for (int k = 0; k < count; ++k) {
        const Plane<Bgr> small = image::resized(shown[static_cast<std::size_t>(k)]->picture, tile);
        const int left = k % columns * tile.width;
        const int top = k / columns * tile.height;
        for (int y = 0; y < tile.height; ++y) {
            for (int x = 0; x < tile.width; ++x) sheet.picture.at(left + x, top + y) = small.at(x, y);
        }
        sheet.seconds.push_back(shown[static_cast<std::size_t>(k)]->seconds);
    }
    return sheet;
}

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

constexpr int still_side = 320;
constexpr std::size_t few_stills = Stills::most / 2;  // with a preview, a page needs them only until that has loaded

/// Whether all current browsers play such a file.
bool browsers_play(const media::VideoInfo& info) {
    const auto is_one_of = [](const std::string& name, std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, name) != names.end();
    };
    return (is_one_of(info.container, {"mp4", "mov"}) && is_one_of(info.codec, {"h264", "av1"})) ||
           (info.container == "webm" && is_one_of(info.codec, {"vp8", "vp9", "av1"}));
}

}  // namespace

Moments MomentWatch::take() {
    Moments moments{times_.stretches(), {}, {}, {}};
    if (stills_) moments.stills = stills_->take();
    if (preview_) moments.preview = preview_->finish();
    if (preview_) moments.problem = preview_->problem();
    return moments;
}

void MomentWatch::begin(const fields::FieldSource& source) {
    const media::VideoInfo& info = source.info();
    ExpectedLength expected{source.expected_frames(), 0};
    if (info.rate > 0) expected.seconds = static_cast<double>(expected.frames) / info.rate;
    times_ = {};
    preview_.reset();
    // A preview of two frames would be useless.
    if (source.has_pictures() && with_preview_) {
        const Preview::Use use = browsers_play(info) ? Preview::Use::fallback : Preview::Use::instead;
        preview_.emplace(info.size, expected, use);
    }
    const bool has_film = preview_ && preview_->is_possible();
    stills_.emplace(fit_into(info.size, still_side), has_film ? few_stills : Stills::most);
}

void MomentWatch::add(const media::SharedFrame& frame, const fields::Field& field) {
    times_.add(field.index, field.pts);
    if (frame->grey.empty() && frame->colour.empty()) return;  // extracted data may have neither
    stills_->add(frame, cv::countNonZero(cv_view(field.scalar)));
    if (preview_) preview_->add(frame);
}

namespace {

constexpr int recent_still_side = 200;
constexpr std::int64_t most_stills = 40;  // live pages are sent often, so they must be small

}  // namespace

RecentMoments::RecentMoments(Size shown, std::int64_t frames)
    : shown_(shown), frames_(std::max<std::int64_t>(1, frames)) {}

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

void RecentMoments::add(const media::Frame& frame, const fields::Field& field) {
    times_.push_back({field.index, field.pts});
    if (std::ssize(times_) > frames_) times_.pop_front();
    while (!stills_.empty() && stills_.front().frame < times_.front().frame) stills_.pop_front();
    const std::int64_t apart = std::max<std::int64_t>(1, frames_ / most_stills);
    if (!stills_.empty() && field.index - stills_.back().frame < apart) return;
    const Plane<Bgr> picture = media::picture_of(frame);
    if (picture.empty()) return;
    stills_.push_back({field.index, field.pts, image::resized(picture, fit_into(shown_, recent_still_side))});
}

}  // namespace vvr::page
