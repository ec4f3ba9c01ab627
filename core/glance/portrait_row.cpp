#include "core/glance/portrait_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace vvr::glance {

namespace {

constexpr double crossing_cost = 1e6;  // exceeds the sum of all lengths
constexpr double obstacle_cost = 300;  // detour in pixels that avoiding an obstacle is worth

/// Twice the signed area of the triangle a, b, c: its sign is the direction of the turn.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool intersects(const glm::dvec2& from, const glm::dvec2& to, const PixelBox& box) {
    const glm::dvec2 corners[] = {
        {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}};
    for (std::size_t i = 0; i < 4; ++i) {
        if (lines_cross(from, to, corners[i], corners[(i + 1) % 4])) return true;
    }
    return false;
}

/// The centres closest to `wished` that are in order and at least `step` apart, by isotonic regression (pool adjacent
/// violators).
std::vector<double> spread(std::span<const double> wished, double step, double low, double high) {
    struct Pool {
        double sum;
        int count;
        double mean() const { return sum / count; }
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < wished.size(); ++i) {
        pools.push_back({wished[i] - static_cast<double>(i) * step, 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            pools[pools.size() - 2].sum += pools.back().sum;
            pools[pools.size() - 2].count += pools.back().count;
            pools.pop_back();
        }
    }
    const double highest = std::max(low, high - step * static_cast<double>(wished.size() - 1));
    std::vector<double> centres;
    for (const Pool& pool : pools) {
        for (int i = 0; i < pool.count; ++i) {
            centres.push_back(std::clamp(pool.mean(), low, highest) + static_cast<double>(centres.size()) * step);
        }
    }
    return centres;
}

/// A row of a fixed set of portraits.
class Row {
  public:
    Row(std::span<const WantedPortrait> wanted, std::vector<std::size_t> order, const PixelBox& row, int gap,
        std::span<const PixelBox> obstacles)
        : wanted_(wanted), order_(std::move(order)), row_(row), step_(row.height() + gap), obstacles_(obstacles) {
        std::ranges::sort(order_, {}, [&](std::size_t k) { return std::pair(wanted[k].seconds, k); });
    }

    std::vector<PlacedPortrait> place() const {
        std::vector<double> wished;
        for (const std::size_t k : order_) {
            const auto& anchors = wanted_[k].anchors;
            wished.push_back(std::ranges::min_element(anchors, {}, &Anchor::cost)->pixel.x);
        }
        std::vector<PlacedPortrait> placed;
        // Stills and anchors depend on each other, so iterate.
        for (int round = 0; round < 3; ++round) {
            placed = choose_anchors(stills_at(wished));
            for (std::size_t i = 0; i < placed.size(); ++i) wished[i] = placed[i].to.x;
        }
        return placed;
    }

  private:
    std::vector<PlacedPortrait> stills_at(std::span<const double> wished) const {
        const double half = row_.height() / 2.0;
        const std::vector<double> centres = spread(wished, step_, row_.left + half, row_.right - half);
        std::vector<PlacedPortrait> stills;
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const int left = static_cast<int>(std::floor(centres[i] - half));
            const PixelBox still{left, row_.top, left + row_.height(), row_.bottom};
            stills.push_back({order_[i], still, {centres[i], row_.bottom}, {}});
        }
        return stills;
    }

    double cost_of(const PlacedPortrait& portrait, const Anchor& anchor) const {
        const auto intersected = std::ranges::count_if(
            obstacles_, [&](const PixelBox& box) { return intersects(portrait.from, anchor.pixel, box); });
        return glm::distance(portrait.from, anchor.pixel) + anchor.cost +
               obstacle_cost * static_cast<double>(intersected);
    }

    /// Chooses the anchors with the shortest lines that don't cross a neighbour's, by dynamic programming along the
    /// row.
    std::vector<PlacedPortrait> choose_anchors(std::vector<PlacedPortrait> row) const {
        std::vector<std::vector<double>> costs(row.size());
        std::vector<std::vector<std::size_t>> before(row.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            for (const Anchor& anchor : wanted_[row[i].wanted].anchors) {
                double least = i == 0 ? 0 : std::numeric_limits<double>::infinity();
                std::size_t from = 0;
                for (std::size_t k = 0; i > 0 && k < costs[i - 1].size(); ++k) {
                    const glm::dvec2& other = wanted_[row[i - 1].wanted].anchors[k].pixel;
                    const bool cross = lines_cross(row[i - 1].from, other, row[i].from, anchor.pixel);
                    const double cost = costs[i - 1][k] + (cross ? crossing_cost : 0);
                    if (cost < least) {
                        least = cost;
                        from = k;
                    }
                }
                costs[i].push_back(least + cost_of(row[i], anchor));
                before[i].push_back(from);
            }
        }
        std::size_t chosen = 0;
        for (std::size_t i = row.size(); i-- > 0;) {
            if (i + 1 == row.size())
                chosen = static_cast<std::size_t>(std::ranges::min_element(costs[i]) - costs[i].begin());
            row[i].to = wanted_[row[i].wanted].anchors[chosen].pixel;
            chosen = before[i][chosen];
        }
        return row;
    }

    std::span<const WantedPortrait> wanted_;
    std::vector<std::size_t> order_;
    PixelBox row_;
    double step_;
    std::span<const PixelBox> obstacles_;
};

/// The least wanted portrait whose line crosses another.
std::optional<std::size_t> least_wanted_crossing(std::span<const PlacedPortrait> row) {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < row.size(); ++i) {
        for (std::size_t k = i + 1; k < row.size(); ++k) {
            if (!lines_cross(row[i].from, row[i].to, row[k].from, row[k].to)) continue;
            least = std::max(least.value_or(0), std::max(row[i].wanted, row[k].wanted));
        }
    }
    return least;
}

}  // namespace

bool lines_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

std::vector<PlacedPortrait> place_portraits(std::span<const WantedPortrait> wanted, const PixelBox& row, int gap,
                                            std::span<const PixelBox> obstacles) {
    const int step = row.height() + gap;
    if (row.height() <= 0) return {};
    const auto most = static_cast<std::size_t>(std::max(0, (row.width() + gap) / step));
    std::vector<std::size_t> order;
    std::size_t next = 0;
    while (true) {
        for (; order.size() < most && next < wanted.size(); ++next) {
            if (!wanted[next].anchors.empty()) order.push_back(next);
        }
        if (order.empty()) return {};
        std::vector<PlacedPortrait> placed = Row(wanted, order, row, gap, obstacles).place();
        const std::optional<std::size_t> crossing = least_wanted_crossing(placed);
        if (!crossing) return placed;
        std::erase(order, *crossing);
    }
}

}  // namespace vvr::glance
