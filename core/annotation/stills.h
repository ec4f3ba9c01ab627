#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/annotation/objects.h"
#include "core/annotation/sheet.h"
#include "core/base/plane.h"
#include "core/media/frame.h"

namespace vvr::annotation {

/// Where an object is in a frame.
struct ObjectInStill {
    std::size_t track = 0;
    PixelBox box{};  ///< field pixels
};

/// A small picture of one frame.
struct Still {
    std::int64_t frame = 0;  ///< index in the clip
    double seconds = 0;
    Plane<Bgr> picture;
    std::vector<ObjectInStill> objects{};
};

/// Keeps stills spread evenly over a stream of unknown length. It divides the stream into stretches of equal length and
/// keeps the most active frame of each. When there are too many stretches, it merges neighbours in pairs.
class Stills {
  public:
    /// Maximum number of stills. For at least as many frames, more than half of it are kept.
    static constexpr std::size_t most = 160;

    /// \param size size of the stills
    /// \param most_kept maximum number of stills, even
    explicit Stills(Size size, std::size_t most_kept = most) : size_(size), most_(most_kept) {}

    /// \param frame has its index in the clip; kept until the end of its stretch
    /// \param activity any measure, such as the number of moving pixels
    /// \param objects in the frame, if anyone asks for them
    void add(const media::SharedFrame& frame, std::int64_t activity, std::vector<ObjectInStill> objects = {});

    /// The stills in order of time. Call it once.
    std::vector<Still> take();

  private:
    struct Kept {
        Still still;
        std::int64_t activity = 0;
    };

    void end_stretch();
    void merge_neighbours();

    Size size_;
    std::size_t most_;
    std::int64_t stretch_ = 1;  ///< frames
    std::int64_t in_last_ = 0;  ///< frames in the last stretch so far
    media::SharedFrame best_;   ///< the most active frame of the last stretch; resized only at its end
    std::int64_t best_activity_ = 0;
    std::vector<ObjectInStill> best_objects_{};
    std::vector<Kept> kept_;  ///< of the stretches before
};

/// A part of a frame that a picture shows.
struct ShownStill {
    const Still* still = nullptr;
    PixelBox part{};                    ///< field pixels; all of the frame if its objects are large
    std::vector<ObjectInStill> marked;  ///< of each event in it, with the event's index as its track
};

/// Chooses the stills that tell most of the events, in order of time: each event is seen large in one of them, if there
/// is room, and nothing is shown twice.
/// \param field size of a field, in whose pixels boxes are
/// \param aspect a still's width divided by its height
std::vector<ShownStill> choose_stills(std::span<const Still> stills, std::span<const tracking::Event> events,
                                      Size field, double aspect, std::size_t most);

/// Draws stills into the sheet's places for them, with their times, and the numbers of the objects in them.
void label_stills(const Objects& objects, std::span<const Still> stills, Size field, const Sheet& sheet,
                  const image::Rgba& pale, const image::Rgba& lines, Lettering& lettering);

}  // namespace vvr::annotation
