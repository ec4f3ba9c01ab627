#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace vvr {

/// Width and height in pixels.
struct Size {
    int width = 0;
    int height = 0;

    friend bool operator==(const Size&, const Size&) = default;
};

using Bgr = std::array<std::uint8_t, 3>;

/// A picture with one value of type T per pixel, rows from the top, no padding.
template <class T>
class Plane {
  public:
    Plane() = default;
    explicit Plane(Size size, T value = T{}) : Plane(for_overwrite(size)) { std::ranges::fill(pixels(), value); }

    /// An uninitialised plane, for callers that write every value: zeroing whole frames costs measurable time.
    static Plane for_overwrite(Size size) {
        Plane plane;
        plane.count_ = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
        plane.pixels_ = std::make_unique_for_overwrite<T[]>(plane.count_);
        plane.size_ = size;
        return plane;
    }

    Plane(const Plane& other) : Plane(for_overwrite(other.size_)) { std::ranges::copy(other.pixels(), pixels_.get()); }
    Plane(Plane&& other) noexcept { swap(other); }
    Plane& operator=(const Plane& other) { return *this = Plane(other); }
    Plane& operator=(Plane&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Plane() = default;

    Size size() const { return size_; }
    int width() const { return size_.width; }
    int height() const { return size_.height; }
    bool empty() const { return count_ == 0; }

    std::span<T> pixels() { return {pixels_.get(), count_}; }
    std::span<const T> pixels() const { return {pixels_.get(), count_}; }

    /// Row `j`, counted from the top.
    std::span<T> row(int j) { return pixels().subspan(offset(0, j), static_cast<std::size_t>(size_.width)); }
    std::span<const T> row(int j) const {
        return pixels().subspan(offset(0, j), static_cast<std::size_t>(size_.width));
    }

    /// The value at column `i` from the left, row `j` from the top.
    T& at(int i, int j) { return pixels_[offset(i, j)]; }
    const T& at(int i, int j) const { return pixels_[offset(i, j)]; }

  private:
    void swap(Plane& other) noexcept {
        std::swap(size_, other.size_);
        std::swap(count_, other.count_);
        pixels_.swap(other.pixels_);
    }

    std::size_t offset(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(i);
    }

    Size size_;
    std::size_t count_ = 0;
    std::unique_ptr<T[]> pixels_;
};

/// Shrinks a size in proportion until its longer side is at most `side` pixels.
inline Size fit_into(Size size, int side) {
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(size.width, size.height));
    return {std::max(1, static_cast<int>(std::lround(size.width * scale))),
            std::max(1, static_cast<int>(std::lround(size.height * scale)))};
}

/// A rectangle of pixels, half-open: columns [left, right), rows [top, bottom).
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }
    int width() const { return right - left; }
    int height() const { return bottom - top; }
    Size size() const { return {width(), height()}; }

    PixelBox translated(int x, int y) const { return {left + x, top + y, right + x, bottom + y}; }
    PixelBox inflated(int x, int y) const { return {left - x, top - y, right + x, bottom + y}; }

    bool contains(const PixelBox& other) const {
        return other.left >= left && other.right <= right && other.top >= top && other.bottom <= bottom;
    }
    bool intersects(const PixelBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }

    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The smallest box that contains both; an empty box adds nothing.
inline PixelBox bounding_box(const PixelBox& a, const PixelBox& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

/// The intersection of two boxes; empty if they don't intersect.
inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

/// The part of a plane in a box, which lies within it.
template <class T>
Plane<T> cropped(const Plane<T>& plane, const PixelBox& box) {
    auto part = Plane<T>::for_overwrite(box.size());
    for (int j = 0; j < box.height(); ++j) {
        std::copy_n(plane.row(box.top + j).begin() + box.left, box.width(), part.row(j).begin());
    }
    return part;
}

/// Sets the pixels of a box, as far as it lies within the plane.
template <class T>
void fill(Plane<T>& plane, const PixelBox& box, const std::type_identity_t<T>& value) {
    const PixelBox inside = intersection(box, {0, 0, plane.width(), plane.height()});
    if (inside.empty()) return;
    for (int j = inside.top; j < inside.bottom; ++j) {
        std::fill_n(plane.row(j).begin() + inside.left, inside.width(), value);
    }
}

}  // namespace vvr
