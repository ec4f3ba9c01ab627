#include "core/dataset/scalar_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/image/picture_file.h"

namespace vvr::dataset {

Plane<std::uint8_t> read_scalar(const std::filesystem::path& file, Size size) {
    const Plane<float> values = image::read_grey_samples(file, size);
    // Written this way, the condition also finds NaN.
    const auto wrong = std::ranges::find_if(values.pixels(), [](float v) { return !(v >= 0 && v <= 1); });
    if (wrong != values.pixels().end()) {
        const auto place = wrong - values.pixels().begin();
        throw Error(
            ErrorCode::file_invalid,
            fmt::format("'{}': the pixel at column {}, row {} is {}, but a scalar field has values from 0 to 1; "
                        "scale the values before they are written",
                        file.string(), place % size.width, place / size.width, *wrong));
    }
    auto scalar = Plane<std::uint8_t>::for_overwrite(size);
    std::ranges::transform(values.pixels(), scalar.pixels().begin(),
                           [](float v) { return static_cast<std::uint8_t>(std::lround(255 * v)); });
    return scalar;
}

}  // namespace vvr::dataset
