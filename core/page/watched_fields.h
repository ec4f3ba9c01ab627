#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fields/field_source.h"
#include "core/page/preview.h"
#include "core/page/stills.h"
#include "core/page/time_line.h"

namespace vvr::page {

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
    enum class EncodedVideo {
        none,
        preview,  ///< small where browsers play the clip itself
    };

    WatchedFields(std::unique_ptr<fields::FieldSource> fields, EncodedVideo film);

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
    EncodedVideo video_;
    Timeline times_;
    std::optional<Stills> stills_;
    std::optional<Preview> preview_;
    std::future<void> encoding_;  ///< of the frame before: an encoder takes as long as the fields do
};

}  // namespace vvr::page
