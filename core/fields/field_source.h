#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"
#include "core/fields/reference.h"
#include "core/media/frame_gaps.h"
#include "core/media/frame_source.h"

namespace vvr::fields {

/// Receives the empty scene, once, before the first field. It is not called where the fields need no empty scene.
using SceneSink = std::function<void(const Reference&)>;

/// The result of a pass over a clip.
struct FieldSummary {
    std::int64_t frames = 0;                            ///< frames that reached the sink
    std::int64_t damaged = 0;                           ///< packets that failed to decode
    std::vector<media::Damage> damage{};                ///< when; empty for an extraction, which does not know it
    Reference reference;                                ///< empty if none was needed
    std::vector<std::string> problems{};                ///< problems of the files that were read, one sentence each
    std::vector<condition::Interval> doubtful_times{};  ///< as of the source
};

/// Reads every frame of `source` once and passes its field to `sink` (§3, video processing sub-system): decodes in
/// order, computes fields in parallel, calls `sink` in order. Memory doesn't depend on the clip's length. Fields don't
/// depend on the number of threads. Except with adaptive methods (`running`, `mog2`, `knn`), they don't depend on where
/// `options.span` begins either.
///
/// \throws Error usage for invalid options, not_video if no frame decodes; and whatever `sink` throws
FieldSummary compute_fields(media::FrameSource& source, const FieldOptions& options, const FieldSink& sink,
                            const SceneSink& scene_sink = {}, const LivingFinder& find_living = {});

/// A frame, and the decoded picture to which it refers, if that is kept.
struct ReadFrame {
    ReadFrame(media::Frame made, std::shared_ptr<const media::DecodedFrame> kept = nullptr)
        : frame(std::move(made)), decoded(std::move(kept)) {}

    media::Frame frame;
    std::shared_ptr<const media::DecodedFrame> decoded;
};

/// Makes one frame. Called once, on any thread.
using FrameJob = std::function<ReadFrame()>;

/// Returns the next frame's job, from one thread at a time; an empty function at the end.
using FrameReader = std::function<FrameJob()>;

/// Computes the fields of frames that come from no FrameSource; all must have the same size.
/// \returns the number of frames that reached the sink
std::int64_t compute_fields(const FrameReader& read, const EmptyScene& scene, const FieldOptions& options,
                            const FieldSink& sink);

/// What a caller needs besides the scalar fields.
struct FieldNeeds {
    bool seeds = true;
    bool flow = true;
    bool flow_of_every_frame = false;  ///< flow at all frames
    bool colour = false;               ///< every frame's picture; else those of the first and last frame suffice
    bool full_size = false;            ///< decoded pictures in full size, for `media::crop_of` in the sink
    std::int64_t every = 1;            ///< seeds and flow at frames whose number is a multiple of this
    SceneSink scene{};                 ///< who wants the empty scene
    LivingFinder find_living{};        ///< keeps whoever it finds out of the empty scene
};

/// The source of a clip's fields: computed from its frames, or read from data files (yellow boxes of Fig. 3).
class FieldSource {
  public:
    FieldSource() = default;
    virtual ~FieldSource() = default;
    FieldSource(const FieldSource&) = delete;
    FieldSource& operator=(const FieldSource&) = delete;

    virtual const media::VideoInfo& info() const = 0;
    virtual Size field_size() const = 0;

    /// The number of fields according to the clip's header; 0 = unknown.
    virtual std::int64_t expected_frames() const = 0;

    /// The smallest interval of seeds and flow that is at least `asked` and possible.
    virtual std::int64_t interval(std::int64_t asked) const { return asked; }

    /// Whether every frame can have its picture.
    virtual bool has_pictures() const { return true; }

    /// Passes all fields to the sink, in order, at each call. Frames between the first and the last may lack a picture.
    virtual FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) = 0;

    /// Passes the frames at some times again, with their pictures in full size. Passes none where they can't be had.
    /// \param times of frames that `read` passed, ascending; the frames that come have the same
    virtual void read_again(std::span<const double> /*times*/,
                            const std::function<void(const media::Frame&)>& /*sink*/) {}
};

/// Fields that are computed from a clip.
class ClipFields final : public FieldSource {
  public:
    ClipFields(std::unique_ptr<media::FrameSource> clip, FieldOptions options);

    const media::VideoInfo& info() const override { return clip_->info(); }
    Size field_size() const override { return clip_->field_size(); }
    std::int64_t expected_frames() const override { return media::expected_frames(clip_->info(), options_.span); }
    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;
    void read_again(std::span<const double> times, const std::function<void(const media::Frame&)>& sink) override;

  private:
    std::unique_ptr<media::FrameSource> clip_;
    FieldOptions options_;
    bool begun_ = false;
    bool shakes_ = false;
};

}  // namespace vvr::fields
