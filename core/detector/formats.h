#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

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

/// A cell of one of the grids that divide a network's input.
struct Cell {
    int column = 0;
    int row = 0;
    int side = 0;  ///< input pixels
};

/// An object that a network has found.
struct Candidate {
    InputBox box;
    int class_id = 0;  ///< index in object_classes()
    float score = 0;
};

/// A family of models. Its output has one row per box: the box in four numbers, the probability that there is an
/// object, and the probability of each class. The rows follow the cells of three grids, finest first.
struct Format {
    std::string_view name;
    int boxes_per_cell = 1;
    ChannelOrder order = ChannelOrder::bgr;  ///< of the input
    double scale = 1;                        ///< input value per grey level
    InputBox (*decode)(std::span<const float, 4> box, const Cell& cell);
};

std::span<const Format> formats();

/// The rows of a format's output for an input of that size.
int rows_of(const Format& format, Size input);

/// The numbers in a row.
int row_length();

/// The format whose output has that shape; null = none.
const Format* find_format(std::span<const int> shape, Size input);

/// The candidates of an output with at least that score.
/// \param output all rows
std::vector<Candidate> decode(const Format& format, std::span<const float> output, Size input, float threshold);

}  // namespace vvr::detector
