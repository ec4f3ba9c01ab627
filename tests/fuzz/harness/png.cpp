// PNG files, by libpng.
#include <algorithm>
#include <span>

#include "core/image/picture_file.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    constexpr std::size_t width = 16;  // where a PNG's size is
    constexpr std::size_t header = 24;
    if (input.size() < header || !input.starts_with("\x89PNG\r\n\x1a\n")) return;
    // Only small pictures: a large one is only slow.
    const auto is_small = [&](std::size_t at) { return input.substr(at, 3) == std::string_view("\0\0\0", 3); };
    if (!is_small(width) || !is_small(width + 4)) return;
    const auto samples = parsed([&] { return image::decode_samples("a.png", std::as_bytes(std::span(input))); });
    if (!samples) return;
    const auto values = static_cast<std::size_t>(samples->size.width * samples->size.height) * samples->channels.size();
    require(samples->values.size() == values, "each pixel has a value per channel");
    require(std::ranges::all_of(samples->values, [](float v) { return v >= 0 && v <= 1; }), "values are from 0 to 1");
}
