#include "tests/scene/y4m.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace vvr::generator {
namespace {

std::uint8_t to_level(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

double luma(Bgr colour) {
    return 0.114 * colour[0] + 0.587 * colour[1] + 0.299 * colour[2];
}

/// The mean of the up to four pixels that share a sample of chroma.
std::array<double, 3> mean_of_block(const Plane<Bgr>& picture, int i, int j) {
    std::array<double, 3> sum{};
    int count = 0;
    for (int y = 2 * j; y < std::min(2 * j + 2, picture.height()); ++y)
        for (int x = 2 * i; x < std::min(2 * i + 2, picture.width()); ++x) {
            for (std::size_t c = 0; c < 3; ++c) sum[c] += picture.at(x, y)[c];
            ++count;
        }
    for (auto& value : sum) value /= count;
    return sum;
}

std::string planes_of(const Plane<Bgr>& picture) {
    std::string bytes;
    for (const Bgr& colour : picture.pixels()) bytes += static_cast<char>(to_level(16 + luma(colour) * 219 / 255));
    std::string red;
    for (int j = 0; j < (picture.height() + 1) / 2; ++j)
        for (int i = 0; i < (picture.width() + 1) / 2; ++i) {
            const auto mean = mean_of_block(picture, i, j);
            const double y = 0.114 * mean[0] + 0.587 * mean[1] + 0.299 * mean[2];
            bytes += static_cast<char>(to_level(128 + (mean[0] - y) / 1.772 * 224 / 255));
            red += static_cast<char>(to_level(128 + (mean[2] - y) / 1.402 * 224 / 255));
        }
    return bytes + red;
}

}  // namespace

void write_y4m(const Scene& scene, std::ostream& out) {
    out << "YUV4MPEG2 W" << scene.size().width << " H" << scene.size().height << " F"
        << std::lround(scene.rate() * 1000) << ":1000 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n";
    for (int i = 0; i < scene.frames() && out; ++i) {
        const auto bytes = planes_of(scene.frame(i));
        out << "FRAME\n";
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    out.flush();
    if (!out) throw std::runtime_error("the scene can't be written: is the disk full, or the pipe closed?");
}

}  // namespace vvr::generator
