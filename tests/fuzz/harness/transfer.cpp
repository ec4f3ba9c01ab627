// Transfer functions.
#include <cmath>

#include "core/scene/transfer_function.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string text(fuzz::text_of(data, size));
    const auto function = fuzz::parsed([&] { return scene::parse_transfer(text, "transfer.txt"); });
    if (!function) return 0;
    for (int value = 0; value < 256; ++value) {
        const glm::dvec4 seen = function->at(value);
        for (int k = 0; k < 4; ++k)
            fuzz::require(std::isfinite(seen[k]) && seen[k] >= 0, "colour and opacity are numbers");
    }
    return 0;
}
