#pragma once

#include <deque>
#include <limits>
#include <memory>

#include "core/base/moment.h"
#include "core/fields/field_source.h"
#include "core/page/watched_fields.h"

namespace vvr::page {

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
