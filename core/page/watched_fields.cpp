#include "core/page/watched_fields.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "core/base/fit_into.h"

namespace vvr::page {

namespace {

constexpr int still_side = 240;
constexpr int small_still_side = 200;
constexpr std::size_t few_stills =
    Stills::most / 2;  // where there is a film too, stills are only the first that is seen of a moment

/// Whether all browsers of the last years play such a file.
bool browsers_play(const video::VideoInfo& info) {
    const auto is_one_of = [](const std::string& name, std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, name) != names.end();
    };
    return (is_one_of(info.container, {"mp4", "mov"}) && is_one_of(info.codec, {"h264", "av1"})) ||
           (info.container == "webm" && is_one_of(info.codec, {"vp8", "vp9", "av1"}));
}

}  // namespace

WatchedFields::WatchedFields(std::unique_ptr<fields::FieldSource> fields, EncodedVideo film)
    : fields_(std::move(fields)), video_(film) {}

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
    // With pictures of only two frames, a film is of no use.
    if (has_pictures() && video_ == EncodedVideo::preview) {
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

}  // namespace vvr::page
