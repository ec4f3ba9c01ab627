// Transfer functions.
#include <cmath>

#include "core/scene/transfer_function.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const std::string text(input);
    const auto function = parsed([&] { return scene::parse_transfer(text, "transfer.txt"); });
    if (!function) return;
    for (int value = 0; value < 256; ++value) {
        const glm::dvec4 seen = function->at(value);
        for (int k = 0; k < 4; ++k) require(std::isfinite(seen[k]) && seen[k] >= 0, "colour and opacity are numbers");
    }
}
