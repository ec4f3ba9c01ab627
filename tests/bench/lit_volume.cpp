#include "tests/bench/lit_volume.h"

#include <algorithm>

namespace vvr::bench {

bricks::Volume lit_volume(Size size, int frames, double share, bool coloured) {
    bricks::Volume volume(size, {frames});
    Plane<std::uint8_t> scalar(size);
    for (int j = 0; j < size.height; ++j) {
        std::ranges::fill(scalar.row(j).first(static_cast<std::size_t>(share * size.width)), std::uint8_t{160});
    }
    const Plane<Bgr> colour = coloured ? Plane<Bgr>(size, Bgr{40, 80, 160}) : Plane<Bgr>();
    for (int i = 0; i < frames; ++i) {
        fields::Field field;
        field.index = i;
        field.pts = i / 25.0;
        field.scalar = scalar;
        volume.add(field, colour);
    }
    return volume;
}

}  // namespace vvr::bench
