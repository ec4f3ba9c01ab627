#include "tests/scene/texture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace vvr::generator {
namespace {

/// The sine within 1e-12, for angles below 1e9. Unlike std::sin, a compiler computes several of it at once, and these
/// are most of what a picture costs.
double sine(double angle) {
    constexpr double to_integer = 0x1.8p52;  // a double above it has no room for a fraction
    const double shifted = angle / std::numbers::pi + to_integer;
    const double halves = shifted - to_integer;
    constexpr double pi_high = 0x1.921fb54p1;  // few bits, so that its product with `halves` is exact
    const double x = (angle - halves * pi_high) - halves * (std::numbers::pi - pi_high);
    constexpr std::array terms{1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
                               1 / 362880.0,          -1 / 5040.0,          1 / 120.0,        -1 / 6.0};
    double sum = 0;
    for (const double term : terms) sum = (sum + term) * (x * x);
    // An odd number of half turns turns the sign.
    const std::uint64_t odd = std::bit_cast<std::uint64_t>(shifted) << 63;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x + x * sum) ^ odd);
}

}  // namespace

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
    constexpr double turn = 2 * std::numbers::pi;
    for (std::size_t i = 0; i < count; ++i) {
        const double length = finest * std::pow(coarsest / finest, static_cast<double>(i) / (count - 1));
        const double angle = turn * unit(seed * 64 + i);
        kx_[i] = turn / length * std::cos(angle);
        ky_[i] = turn / length * std::sin(angle);
        phase_[i] = turn * unit(seed * 64 + 32 + i);
    }
}

double Texture::operator()(double x, double y) const {
    std::array<double, count> waves{};
    for (std::size_t i = 0; i < count; ++i) waves[i] = sine(kx_[i] * x + ky_[i] * y + phase_[i]);
    double sum = 0;
    for (const double wave : waves) sum += wave;
    // The sum of sixteen waves has a spread of 2.8.
    return std::clamp(0.5 + sum / 14, 0.0, 1.0);
}

}  // namespace vvr::generator
