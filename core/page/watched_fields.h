#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/fields/field_source.h"
#include "core/page/preview.h"
#include "core/page/stills.h"
#include "core/page/time_line.h"

namespace vvr {

/// What a page needs to know about the moments of a clip.
struct Moments {
    std::vector<SteadyFrames> times;
    std::vector<Still> stills;
    std::optional<Film> preview;
};

/// Takes times, stills and a preview from fields as they are read: a page needs no second pass over the clip.
class WatchedFields final : public FieldSource {
  public:
    explicit WatchedFields(std::unique_ptr<FieldSource> fields);

    const VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }
    std::int64_t expected_frames() const override { return fields_->expected_frames(); }
    std::int64_t interval(std::int64_t asked) const override { return fields_->interval(asked); }
    bool has_pictures() const override { return fields_->has_pictures(); }
    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;

    /// The moments of the last `read`. Call it once.
    Moments take();

  private:
    void begin();
    void look_at(const Frame& frame, const Field& field);

    std::unique_ptr<FieldSource> fields_;
    TimeLine times_;
    std::optional<Stills> stills_;
    std::optional<Preview> preview_;
};

}  // namespace vvr
