#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/fields/field_source.h"
#include "core/page/preview.h"
#include "core/page/stills.h"

namespace vvr::page {

/// Consecutive frames at a steady rate.
struct ConstantRateFrames {
    std::int64_t first = 0;  ///< index in the clip
    std::int64_t count = 1;
    double begin = 0;  ///< seconds, of the first
    double step = 0;   ///< seconds from each to the next; 0 where there is only one

    double at(std::int64_t frame) const { return begin + static_cast<double>(frame - first) * step; }
};

/// The times of a clip's frames in few numbers: a clip at a steady rate is one stretch, of any length and with any
/// rounding by its container. Memory grows only with the changes of the rate.
class Timeline {
  public:
    /// The greatest error of a frame's time, in seconds: less than the shortest time that a screen shows a frame.
    static constexpr double tolerance = 0.001;

    /// \param frame greater than the one before; so is its time in most clips
    void add(std::int64_t frame, double seconds);

    std::vector<ConstantRateFrames> stretches() const;

    std::int64_t frames() const { return frames_; }

  private:
    void begin(std::int64_t frame, double seconds);
    ConstantRateFrames current() const;

    std::vector<ConstantRateFrames> done_;
    std::int64_t frames_ = 0;
    std::int64_t first_ = 0;
    std::int64_t count_ = 0;
    double begin_ = 0;
    double least_ = 0;  ///< any step from this to `most_` keeps all frames of the stretch within the tolerance
    double most_ = 0;
};

/// What a page needs to know about the moments of a clip.
struct Moments {
    std::vector<ConstantRateFrames> times;
    std::vector<Still> stills;
    std::optional<EncodedVideo> preview;
    std::string problem{};  ///< why the preview could not be made; empty = it could, or none was due
};

/// Takes times, stills and a preview from fields as they are read: a page needs no second pass over the clip.
class WatchedFields final : public fields::FieldSource {
  public:
    /// \param with_preview small where browsers play the clip itself
    WatchedFields(std::unique_ptr<fields::FieldSource> fields, bool with_preview);

    const video::VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }
    std::int64_t expected_frames() const override { return fields_->expected_frames(); }
    std::int64_t interval(std::int64_t asked) const override { return fields_->interval(asked); }
    bool has_pictures() const override { return fields_->has_pictures(); }
    fields::FieldSummary read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) override;

    /// The moments of the last `read`. Call it once.
    Moments take();

  private:
    void begin();
    void look_at(const video::Frame& frame, const fields::Field& field);
    void encode(const fields::Field& field, Plane<Bgr>&& picture);

    std::unique_ptr<fields::FieldSource> fields_;
    bool with_preview_;
    Timeline times_;
    std::optional<Stills> stills_;
    std::optional<Preview> preview_;
    std::future<void> encoding_;  ///< of the frame before: an encoder takes as long as the fields do
};

/// Takes times and stills from the fields of a stream as they come, and keeps those of its last frames. Its memory is
/// bounded by the number of frames that are kept.
class RecentMoments final : public fields::FieldSource {
  public:
    /// \param frames that are kept
    RecentMoments(std::unique_ptr<fields::FieldSource> fields, std::int64_t frames);

    const video::VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }
    std::int64_t expected_frames() const override { return fields_->expected_frames(); }
    std::int64_t interval(std::int64_t asked) const override { return fields_->interval(asked); }
    bool has_pictures() const override { return fields_->has_pictures(); }
    fields::FieldSummary read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) override;

    /// The moments from this frame on, until the last of a picture. There is no preview.
    Moments since(std::int64_t first, std::int64_t last = std::numeric_limits<std::int64_t>::max()) const;

  private:
    void look_at(const video::Frame& frame, const fields::Field& field);

    std::unique_ptr<fields::FieldSource> fields_;
    std::int64_t frames_;
    std::deque<Moment> times_;
    std::deque<Still> stills_;
};

}  // namespace vvr::page
