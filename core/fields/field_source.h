#pragma once

#include <cstdint>
#include <memory>

#include "core/fields/pipeline.h"
#include "core/video/frame_source.h"

namespace vvr::fields {

/// What is wanted of the fields besides the scalar.
struct FieldNeeds {
    bool seeds = true;
    bool flow = true;
    bool flow_of_every_frame = false;  ///< flow at all frames
    bool colour = false;        ///< every frame's own picture too; else that of the first and the last will do
    std::int64_t every = 1;     ///< seeds and flow at frames whose index is a multiple of it
};

/// Where a clip's fields come from: computed out of its frames, or read back from data files (Fig. 3's yellow boxes).
class FieldSource {
  public:
    FieldSource() = default;
    virtual ~FieldSource() = default;
    FieldSource(const FieldSource&) = delete;
    FieldSource& operator=(const FieldSource&) = delete;

    virtual const video::VideoInfo& info() const = 0;
    virtual Size field_size() const = 0;

    /// How many fields there are as far as the clip's header tells; 0 = unknown.
    virtual std::int64_t expected_frames() const = 0;

    /// The nearest interval to `asked`, not below it, at which there can be seeds and flow.
    virtual std::int64_t interval(std::int64_t asked) const { return asked; }

    /// Whether every frame can come with its picture.
    virtual bool has_pictures() const { return true; }

    /// Gives every field from the first on, in order, whenever it is called. Frames between the first and the last
    /// may come without a picture.
    virtual FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) = 0;
};

/// Fields computed from a clip.
class ClipFields final : public FieldSource {
  public:
    ClipFields(std::unique_ptr<video::FrameSource> clip, FieldOptions options);

    const video::VideoInfo& info() const override { return clip_->info(); }
    Size field_size() const override { return clip_->field_size(); }
    std::int64_t expected_frames() const override { return vvr::video::expected_frames(clip_->info(), options_.span); }
    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;

  private:
    std::unique_ptr<video::FrameSource> clip_;
    FieldOptions options_;
    bool begun_ = false;
};

}  // namespace vvr::fields
