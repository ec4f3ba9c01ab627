#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vvr {

/// Width and height in pixels.
struct Size {
    int width = 0;
    int height = 0;

    friend bool operator==(const Size&, const Size&) = default;
};

using Bgr = std::array<std::uint8_t, 3>;

/// A picture with one value of type T a pixel, rows from the top, no padding.
template <class T>
class Plane {
  public:
    Plane() = default;
    explicit Plane(Size size, T value = T{})
        : size_(size), pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), value) {}

    Size size() const { return size_; }
    int width() const { return size_.width; }
    int height() const { return size_.height; }
    bool empty() const { return pixels_.empty(); }

    std::span<T> pixels() { return pixels_; }
    std::span<const T> pixels() const { return pixels_; }

    /// Row `j`, counted from the top.
    std::span<T> row(int j) { return pixels().subspan(offset(0, j), static_cast<std::size_t>(size_.width)); }
    std::span<const T> row(int j) const {
        return pixels().subspan(offset(0, j), static_cast<std::size_t>(size_.width));
    }

    /// The value at column `i` from the left, row `j` from the top.
    T& at(int i, int j) { return pixels_[offset(i, j)]; }
    const T& at(int i, int j) const { return pixels_[offset(i, j)]; }

  private:
    std::size_t offset(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(i);
    }

    Size size_;
    std::vector<T> pixels_;
};

}  // namespace vvr
