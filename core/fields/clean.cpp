#include "core/fields/clean.h"

#include <algorithm>
#include <cstddef>

#include "core/fields/blobs.h"

namespace vvr::fields {

void clean(Plane<std::uint8_t>& plane, const CleanOptions& options, const Plane<std::uint8_t>& region) {
    std::uint8_t* const pixels = plane.pixels().data();
    const std::size_t count = plane.pixels().size();
    // Plain byte arithmetic, so that the compiler makes vectors of it.
    const auto threshold = static_cast<std::uint8_t>(options.threshold);
    const auto most = static_cast<std::uint8_t>(255 / options.gain);
    const auto gain = static_cast<std::uint8_t>(options.gain);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t value = pixels[i];
        const auto lit = static_cast<std::uint8_t>(std::min(value, most) * gain);
        const auto shown = static_cast<std::uint8_t>(value > most ? 255 : lit);
        pixels[i] = value < threshold ? std::uint8_t{0} : shown;
    }
    if (!region.empty()) {
        const std::uint8_t* const inside = region.pixels().data();
        for (std::size_t i = 0; i < count; ++i) pixels[i] = inside[i] == 0 ? std::uint8_t{0} : pixels[i];
    }
    remove_small_blobs(plane, options.min_area);
}

}  // namespace vvr::fields
