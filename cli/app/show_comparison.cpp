#include "cli/app/show_comparison.h"

#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/image/difference_view.h"

namespace vvr::app {

namespace {

constexpr std::array<std::string_view, 5> verdicts{"same", "size", "channels", "not-finite", "values"};

}  // namespace

std::string numbers_of(const image::Comparison& comparison) {
    if (!comparison.has_numbers()) return {};
    std::string text;
    const auto line = [&text](const char* name, const std::string& value) {
        text += fmt::format("{:<6} {}\n", name, value);
    };
    line("mean", fmt::format("{:.6f}", comparison.mean));
    line("max", fmt::format("{:.6f}", comparison.max));
    line("rms", fmt::format("{:.6f}", comparison.rms));
    line("psnr", std::isinf(comparison.psnr) ? "infinite" : fmt::format("{:.2f} dB", comparison.psnr));
    line("off", fmt::format("{} of {} pixels, {:.4f} %", comparison.off, comparison.pixels.pixels().size(),
                            comparison.percent));
    line("patch", fmt::format("{:.6f}", comparison.patch));
    return text;
}

nlohmann::ordered_json json_of(const image::Comparison& comparison) {
    nlohmann::ordered_json json{{"same", comparison.verdict == image::Verdict::same},
                                {"verdict", verdicts.at(static_cast<std::size_t>(comparison.verdict))},
                                {"reason", comparison.reason}};
    const auto number = [&](double value) {
        return comparison.has_numbers() && std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
    };
    json["mean"] = number(comparison.mean);
    json["max"] = number(comparison.max);
    json["rms"] = number(comparison.rms);
    json["psnr_db"] = number(comparison.psnr);
    json["pixels_off"] = comparison.has_numbers() ? nlohmann::ordered_json(comparison.off) : nullptr;
    json["percent_off"] = number(comparison.percent);
    json["patch"] = number(comparison.patch);
    json["worst"] = nlohmann::ordered_json::array();
    for (const image::PixelPair& pixel : comparison.worst) {
        json["worst"].push_back(
            {{"x", pixel.column}, {"y", pixel.row}, {"difference", pixel.difference}, {"a", pixel.a}, {"b", pixel.b}});
    }
    return json;
}

void show_difference(const image::Comparison& comparison, const image::Tolerance& tolerance, std::string_view a,
                     std::string_view b, Observer& observer) {
    for (const image::PixelPair& pixel : comparison.worst) {
        observer.info(fmt::format("at {},{}: {} {:.4f} and {} {:.4f} differ by {:.4f}", pixel.column, pixel.row, a,
                                  fmt::join(pixel.a, " "), b, fmt::join(pixel.b, " "), pixel.difference));
    }
    if (!comparison.has_numbers()) return;
    std::istringstream letters(image::difference_letters(comparison.pixels, tolerance.level));
    for (std::string line; std::getline(letters, line);) observer.info(line);
}

}  // namespace vvr::app
