#include <algorithm>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

#include "core/fields/cv_view.h"
#include "core/fields/filter.h"

namespace vvr {
namespace {

// Camera noise is a matter of single pixels: the mean of nine has a third of it, and objects keep their outlines.
template <class T>
Plane<T> smoothed(const Plane<T>& plane) {
    Plane<T> result(plane.size());
    cv::Mat out = cv_view(result);
    cv::GaussianBlur(cv_view(plane), out, {3, 3}, 0, 0, cv::BORDER_REPLICATE);
    return result;
}

int largest_difference(std::uint8_t a, std::uint8_t b) {
    return std::abs(a - b);
}
int largest_difference(const Bgr& a, const Bgr& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

class Difference final : public Filter {
  public:
    Difference(int threshold, const Reference& reference)
        : threshold_(threshold),
          grey_(smoothed(reference.grey)),
          colour_(reference.colour.empty() ? Plane<Bgr>{} : smoothed(reference.colour)) {}

    Plane<std::uint8_t> operator()(const FilterInput& input) const override {
        const bool with_colour = !input.frame.colour.empty() && !colour_.empty();
        return with_colour ? compare(input.frame.colour, colour_) : compare(input.frame.grey, grey_);
    }

  private:
    template <class T>
    Plane<std::uint8_t> compare(const Plane<T>& frame, const Plane<T>& reference) const {
        Plane<std::uint8_t> result(frame.size());
        const Plane<T> smooth = smoothed(frame);
        std::ranges::transform(smooth.pixels(), reference.pixels(), result.pixels().begin(),
                               [&](const T& a, const T& b) {
                                   const int d = largest_difference(a, b);
                                   return static_cast<std::uint8_t>(d < threshold_ ? 0 : std::min(2 * d, 255));
                               });
        return result;
    }

    int threshold_;
    Plane<std::uint8_t> grey_;
    Plane<Bgr> colour_;
};

}  // namespace

std::unique_ptr<Filter> make_difference(const FieldOptions& options, const Reference& reference) {
    return std::make_unique<Difference>(options.threshold, reference);
}

}  // namespace vvr
