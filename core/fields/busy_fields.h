#pragma once

#include <memory>

#include "core/fields/field_source.h"

namespace vvr {

/// Fields without the stretches in which nothing moves: of each that is longer than `longest` only half of that stays
/// at both ends. What lies there without moving, a bag that was left, doesn't count. The frames keep their numbers, so
/// whoever takes them sees where some are left out.
class BusyFields final : public FieldSource {
  public:
    /// \param longest seconds
    BusyFields(std::unique_ptr<FieldSource> fields, double longest) : fields_(std::move(fields)), longest_(longest) {}

    const VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }

    /// Nobody knows before.
    std::int64_t expected_frames() const override { return 0; }
    std::int64_t interval(std::int64_t asked) const override { return fields_->interval(asked); }
    bool has_pictures() const override { return fields_->has_pictures(); }

    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;

  private:
    std::unique_ptr<FieldSource> fields_;
    double longest_;
};

}  // namespace vvr
