#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/annotation/stills.h"
#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/fields/field_source.h"
#include "core/media/frame.h"
#include "core/page/preview.h"
#include "core/tracking/event.h"

namespace vvr::page {

using annotation::Still;
using annotation::Stills;

/// The most informative still of a clip. Events are ranked by kind, then by how long the object stood, then by
/// duration. Without events, it is the middle still.
/// \returns empty if there are no stills
std::optional<Still> best_still(std::span<const Still> stills, std::span<const tracking::Event> events);

/// Small pictures of what happens in a clip, in one: from left to right and from the top down in order of time.
struct ContactSheet {
    static constexpr int columns = 10;
    static constexpr std::size_t most = 60;  ///< pictures

    Plane<Bgr> picture;
    std::vector<double> seconds;  ///< the time of each small picture
};

/// The stills that show events, at least one for each event; the middle one of a clip without events. If there are more
/// than ContactSheet::most, some are left out evenly.
/// \returns empty if there are no stills
std::optional<ContactSheet> contact_sheet(std::span<const Still> stills, std::span<const tracking::Event> events);

/// Consecutive frames at a constant rate.
struct ConstantRateFrames {
    std::int64_t first = 0;  ///< index in the clip
    std::int64_t count = 1;
    double begin = 0;  ///< time of the first frame, seconds
    double step = 0;   ///< seconds per frame; 0 for a single frame

    double at(std::int64_t frame) const { return begin + static_cast<double>(frame - first) * step; }
};

/// Stores the times of a clip's frames compactly, as stretches of constant rate. Memory grows only with the number of
/// rate changes. Rounding by the container doesn't start a new stretch.
class Timeline {
  public:
    /// Maximum error of a frame's time, seconds: less than a screen's refresh period.
    static constexpr double tolerance = 0.001;

    /// \param frame index, greater than the previous one
    /// \param seconds usually greater than the previous time
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
    double least_ = 0;  ///< smallest step that keeps all frames of the stretch within the tolerance
    double most_ = 0;   ///< largest such step
};

/// The times, stills and preview of a clip, for a page.
struct Moments {
    std::vector<ConstantRateFrames> times;
    std::vector<Still> stills;
    std::optional<EncodedVideo> preview;
    std::string problem{};  ///< why encoding the preview failed; empty = no error
};

/// Collects times, stills and a preview while fields are read, so that a page needs no second pass over the clip.
class MomentWatch {
  public:
    /// \param with_preview whether to make a preview; it is small if browsers can play the clip
    explicit MomentWatch(bool with_preview) : with_preview_(with_preview) {}

    /// Call it before the first frame. Forgets what it has.
    void begin(const fields::FieldSource& source);

    void add(const media::SharedFrame& frame, const fields::Field& field);

    /// What was collected. Call it once.
    Moments take();

  private:
    bool with_preview_;
    Timeline times_;
    std::optional<Stills> stills_;
    std::optional<PreviewThread> preview_;  ///< encodes in parallel to the next fields
};

/// Collects times and stills of the most recent frames of a stream. The number of frames bounds its memory.
class RecentMoments {
  public:
    /// \param shown display size of the stream
    /// \param frames number of frames to keep
    RecentMoments(Size shown, std::int64_t frames);

    void add(const media::Frame& frame, const fields::Field& field);

    /// The moments of the frames from `first` to `last`, inclusive, without a preview.
    Moments since(std::int64_t first, std::int64_t last = std::numeric_limits<std::int64_t>::max()) const;

  private:
    Size shown_;
    std::int64_t frames_;
    std::deque<Moment> times_;
    std::deque<Still> stills_;
};

}  // namespace vvr::page
