#include "tests/scene/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr::generator {

std::uint64_t hash(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31);
}

double unit(std::uint64_t value) {
    return static_cast<double>(hash(value) >> 11) * 0x1p-53;
}

Texture::Texture(std::uint64_t seed, double finest, double coarsest) {
    constexpr int count = 16;
    constexpr double turn = 2 * std::numbers::pi;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double length = finest * std::pow(coarsest / finest, static_cast<double>(i) / (count - 1));
        const double angle = turn * unit(seed * 64 + i);
        waves_.push_back(
            {turn / length * std::cos(angle), turn / length * std::sin(angle), turn * unit(seed * 64 + 32 + i)});
    }
}

double Texture::operator()(double x, double y) const {
    double sum = 0;
    for (const auto& wave : waves_) sum += std::sin(wave.kx * x + wave.ky * y + wave.phase);
    // The sum of sixteen waves has a spread of 2.8.
    return std::clamp(0.5 + sum / 14, 0.0, 1.0);
}

}  // namespace vvr::generator
