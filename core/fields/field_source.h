#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"
#include "core/fields/reference.h"
#include "core/video/frame_source.h"

namespace vvr::fields {

/// Receives each frame with its field, in frame order, never from two threads at once.
using FieldSink = std::function<void(const video::SharedFrame&, Field&&)>;

/// What a pass over a clip found.
struct FieldSummary {
    std::int64_t frames = 0;              ///< frames that reached the sink
    std::int64_t damaged = 0;             ///< packets that could not be decoded
    Reference reference;                  ///< empty where nothing asked for one
    std::vector<std::string> problems{};  ///< of files that were read, a sentence each
};

/// Reads every frame of `source` once, in order, and gives its field to `sink`: decoding in order, fields in
/// parallel, `sink` in order (§3's video processing sub-system). Memory doesn't depend on the clip's length, and the
/// fields depend neither on the number of threads nor, but for what learns as it goes (`running`, `mog2`, `knn`), on
/// where `options.span` cuts.
///
/// \throws Error usage for options that can't be, not_video when not one frame decodes; whatever `sink` throws.
FieldSummary compute_fields(video::FrameSource& source, const FieldOptions& options, const FieldSink& sink);

/// What is known of a scene before its first frame.
struct EmptyScene {
    Reference reference;         ///< may be empty where `needs_reference` says so
    Plane<std::uint8_t> region;  ///< 0 = not to be looked at; empty = look everywhere
    std::int64_t frames = 0;     ///< of the clip; 0 = unknown
};

/// Whether these options lead to a comparison with the empty scene: for the filter, or for where seeds may lie.
bool needs_reference(const FieldOptions& options);

/// Makes one frame. Called once, from any thread.
using FrameJob = std::function<video::Frame()>;

/// Gives the jobs of a clip's frames in order, never from two threads at once; an empty function at the end.
using FrameReader = std::function<FrameJob()>;

/// Computes the fields of frames that no FrameSource gives; all must be of one size.
/// \returns the number of frames that reached the sink
std::int64_t compute_fields(const FrameReader& read, const EmptyScene& scene, const FieldOptions& options,
                            const FieldSink& sink);

/// What is wanted of the fields besides the scalar.
struct FieldNeeds {
    bool seeds = true;
    bool flow = true;
    bool flow_of_every_frame = false;  ///< flow at all frames
    bool colour = false;               ///< every frame's own picture too; else that of the first and the last will do
    std::int64_t every = 1;            ///< seeds and flow at frames whose index is a multiple of it
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
