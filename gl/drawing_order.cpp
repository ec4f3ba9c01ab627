#include "gl/drawing_order.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace vvr::gl {

std::vector<DrawnPart> drawing_order(const space::Layout& layout, const glm::dvec3& from,
                                     std::span<const bricks::PlacedCells> bricks, std::span<const double> standing) {
    std::vector<std::size_t> by_time(standing.size());
    std::iota(by_time.begin(), by_time.end(), std::size_t{0});
    std::ranges::sort(by_time, {}, [&](std::size_t i) { return standing[i]; });

    // A picture is a section of no thickness; between pictures without bricks there are sections of nothing.
    std::vector<double> borders = {bricks.empty() ? 0 : bricks.front().t_begin};
    std::vector<std::optional<DrawnPart>> sections;
    const auto add = [&](std::optional<DrawnPart> part, double t_end) {
        sections.push_back(part);
        borders.push_back(t_end);
    };
    auto next = by_time.begin();
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        const double middle = (bricks[i].t_begin + bricks[i].t_end) / 2;
        for (; next != by_time.end() && standing[*next] < middle; ++next) add(DrawnPart{true, *next}, borders.back());
        add(DrawnPart{false, i}, bricks[i].t_end);
    }
    for (; next != by_time.end(); ++next) {
        if (standing[*next] > borders.back()) add(std::nullopt, standing[*next]);
        add(DrawnPart{true, *next}, borders.back());
    }
    std::vector<DrawnPart> order;
    if (sections.empty()) return order;
    for (const int section : layout.back_to_front(from, borders)) {
        const auto& part = sections[static_cast<std::size_t>(section)];
        if (part) order.push_back(*part);
    }
    return order;
}

}  // namespace vvr::gl
