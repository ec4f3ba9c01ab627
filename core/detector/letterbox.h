#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/plane.h"

namespace vvr::detector {

enum class ChannelOrder { bgr, rgb };

/// An image of 8-bit pixels with three channels, not owned.
struct ImageView {
    std::span<const std::uint8_t> bytes;
    Size size;
    std::size_t stride = 0;  ///< bytes from one row to the next
    ChannelOrder order = ChannelOrder::bgr;
};

ImageView view_of(const Plane<Bgr>& image);

/// A box in pixels of the network's input.
struct InputBox {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// How an image fits into the input of a network: scaled in proportion and placed in the upper left corner, the rest
/// grey.
struct Letterbox {
    double scale = 1;  ///< input pixels per image pixel
    Size content;      ///< the scaled image

    /// \param image size of the image; must not be empty
    Letterbox(Size image, Size input);

    /// The box in pixels of the image, clipped to it: empty if it is outside or not a number.
    PixelBox to_image(const InputBox& box, Size image) const;
};

/// The image as the network's input, in its own order of channels.
Plane<Bgr> letterboxed(const ImageView& image, Size input);

}  // namespace vvr::detector
