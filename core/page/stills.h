#pragma once

#include <cstdint>
#include <vector>

#include "core/plane.h"

namespace vvr {

/// A small picture of a moment.
struct Still {
    std::int64_t frame = 0;  ///< index in the clip
    double seconds = 0;
    Plane<Bgr> picture;
};

/// The size of what is `shown`, made smaller to a long side of `side` at most.
Size fit_into(Size shown, int side);

/// A frame at another size, by area averaging.
Plane<Bgr> resized(const Plane<Bgr>& picture, Size size);

/// Keeps stills spread evenly over a stream of frames whose length nobody knows: the stream is cut into stretches of
/// equal length, and each keeps the frame in which most goes on. When there are too many, neighbours become one.
class Stills {
  public:
    /// More than half as many are kept where there are as many frames.
    static constexpr std::size_t most = 160;

    /// \param size of the stills
    explicit Stills(Size size) : size_(size) {}

    /// \param activity how much goes on in it
    void add(std::int64_t frame, double seconds, const Plane<Bgr>& picture, std::int64_t activity);

    /// In order of time. To be called once.
    std::vector<Still> take();

  private:
    struct Kept {
        Still still;
        std::int64_t activity = 0;
    };

    void join_neighbours();

    Size size_;
    std::int64_t stretch_ = 1;  ///< frames
    std::int64_t in_last_ = 0;  ///< frames that the last one stands for
    std::vector<Kept> kept_;
};

}  // namespace vvr
