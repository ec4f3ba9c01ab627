#include "core/detector/formats.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/detector/classes.h"

namespace vvr::detector {

namespace {

constexpr std::uint8_t padding = 114;  // as in training

int scaled(int side, double scale, int most) {
    return std::clamp(static_cast<int>(std::lround(side * scale)), 1, most);
}

}  // namespace

ImageView view_of(const Plane<Bgr>& image) {
    const auto stride = static_cast<std::size_t>(image.width()) * sizeof(Bgr);
    const auto* const first = reinterpret_cast<const std::uint8_t*>(image.pixels().data());
    return {{first, image.pixels().size_bytes()}, image.size(), stride, ChannelOrder::bgr};
}

Letterbox::Letterbox(Size image, Size input)
    : scale(std::min(static_cast<double>(input.width) / image.width, static_cast<double>(input.height) / image.height)),
      content{scaled(image.width, scale, input.width), scaled(image.height, scale, input.height)} {}

PixelBox Letterbox::to_image(const InputBox& box, Size image) const {
    const bool known = !std::isnan(box.left + box.top + box.right + box.bottom);
    if (!known) return {};
    const auto pixel = [this](double place, int most) {
        return static_cast<int>(std::lround(std::clamp(place / scale, 0.0, static_cast<double>(most))));
    };
    return {pixel(box.left, image.width), pixel(box.top, image.height), pixel(box.right, image.width),
            pixel(box.bottom, image.height)};
}

Plane<Bgr> letterboxed(const ImageView& image, Size input) {
    const Letterbox letterbox(image.size, input);
    Plane<Bgr> boxed(input, Bgr{padding, padding, padding});
    const cv::Mat whole(image.size.height, image.size.width, CV_8UC3, const_cast<std::uint8_t*>(image.bytes.data()),
                        image.stride);
    const cv::Size size(letterbox.content.width, letterbox.content.height);
    cv::Mat content = cv_view(boxed)(cv::Rect({0, 0}, size));
    cv::resize(whole, content, size, 0, 0, cv::INTER_LINEAR);  // as in training
    return boxed;
}

namespace {

constexpr std::array cell_sides{8, 16, 32};

InputBox centred(double x, double y, double width, double height) {
    return {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
}

/// The centre in cells from the cell's corner, the logarithm of the size in cells.
InputBox decode_yolox(std::span<const float, 4> box, const Cell& cell) {
    return centred((cell.column + double{box[0]}) * cell.side, (cell.row + double{box[1]}) * cell.side,
                   std::exp(double{box[2]}) * cell.side, std::exp(double{box[3]}) * cell.side);
}

/// The centre and the size in input pixels.
InputBox decode_yolov5(std::span<const float, 4> box, const Cell& /*cell*/) {
    return centred(box[0], box[1], box[2], box[3]);
}

constexpr std::array table{
    Format{.name = "YOLOX", .boxes_per_cell = 1, .order = ChannelOrder::bgr, .scale = 1, .decode = decode_yolox},
    Format{
        .name = "YOLOv5", .boxes_per_cell = 3, .order = ChannelOrder::rgb, .scale = 1.0 / 255, .decode = decode_yolov5},
};

constexpr std::size_t box_numbers = 4;

}  // namespace

std::span<const Format> formats() {
    return table;
}

int rows_of(const Format& format, Size input) {
    int cells = 0;
    for (const int side : cell_sides) cells += (input.width / side) * (input.height / side);
    return cells * format.boxes_per_cell;
}

int row_length() {
    return static_cast<int>(box_numbers + 1 + object_classes().size());
}

const Format* find_format(std::span<const int> shape, Size input) {
    const auto* const row = std::ranges::find_if(table, [&](const Format& format) {
        return std::ranges::equal(shape, std::array{1, rows_of(format, input), row_length()});
    });
    return row == table.end() ? nullptr : row;
}

std::vector<Candidate> decode(const Format& format, std::span<const float> output, Size input, float threshold) {
    const auto length = static_cast<std::size_t>(row_length());
    std::vector<Candidate> candidates;
    const auto add = [&](std::span<const float> row, const Cell& cell) {
        const auto classes = row.subspan(box_numbers + 1);
        const auto best = std::ranges::max_element(classes);
        const float score = row[box_numbers] * *best;
        if (!(score >= threshold)) return;  // also if it is not a number
        candidates.push_back({format.decode(row.first<box_numbers>(), cell), static_cast<int>(best - classes.begin()),
                              std::min(score, 1.0F)});
    };
    std::size_t next = 0;
    for (const int side : cell_sides) {
        for (int box = 0; box < format.boxes_per_cell; ++box) {
            for (int j = 0; j < input.height / side; ++j) {
                for (int i = 0; i < input.width / side; ++i) {
                    add(output.subspan(next, length), {i, j, side});
                    next += length;
                }
            }
        }
    }
    return candidates;
}

}  // namespace vvr::detector
