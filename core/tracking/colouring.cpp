#include "core/tracking/colouring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

namespace vvr::tracking {

namespace {

// The unit of length is the scene's width. Time is scaled as in the picture, where the arc is about four times as long
// as the scene is wide: so neighbours here are neighbours in the picture.
constexpr double widths_of_time = 4;

/// A grid of cells in space-time, with the number of events of each colour in each cell.
class Cells {
  public:
    using Counts = std::array<int, object_colours>;
    using Place = std::array<int, 3>;

    explicit Cells(int across)
        : across_(across),
          along_(across * static_cast<int>(widths_of_time)),
          counts_(static_cast<std::size_t>(across) * static_cast<std::size_t>(across) *
                  static_cast<std::size_t>(along_)) {}

    /// Appends the cells that an object covers, each once.
    /// \param from, to corners of what it covers: 0 to 1 in x and y, 0 to `widths_of_time` in time
    void reach(const glm::dvec3& from, const glm::dvec3& to, std::vector<std::size_t>& cells) const {
        each(place_of(from), place_of(to), [&](std::size_t cell) { cells.push_back(cell); });
    }

    /// The number of events of each colour in these cells and their neighbours.
    Counts about(std::span<const std::size_t> cells) const {
        Counts sum{};
        for (const std::size_t cell : cells) {
            const Place at = place_at(cell);
            each({at[0] - 1, at[1] - 1, at[2] - 1}, {at[0] + 1, at[1] + 1, at[2] + 1}, [&](std::size_t near) {
                for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += counts_[near][c];
            });
        }
        return sum;
    }

    void add(std::span<const std::size_t> cells, std::size_t colour) {
        for (const std::size_t cell : cells) ++counts_[cell][colour];
    }

  private:
    Place place_of(const glm::dvec3& p) const {
        const auto cell = [&](double value) { return static_cast<int>(std::floor(value * across_)); };
        return {cell(p.x), cell(p.y), cell(p.z)};
    }

    Place place_at(std::size_t cell) const {
        const auto i = static_cast<int>(cell);
        return {i % across_, i / across_ % across_, i / across_ / across_};
    }

    template <class Visit>
    void each(Place from, Place to, const Visit& visit) const {
        for (int k = std::max(from[2], 0); k <= std::min(to[2], along_ - 1); ++k) {
            for (int j = std::max(from[1], 0); j <= std::min(to[1], across_ - 1); ++j) {
                for (int i = std::max(from[0], 0); i <= std::min(to[0], across_ - 1); ++i) {
                    visit(static_cast<std::size_t>((k * across_ + j) * across_ + i));
                }
            }
        }
    }

    int across_;
    int along_;
    std::vector<Counts> counts_;
};

/// Converts field pixels and seconds to the coordinates of the cells.
class Scale {
  public:
    explicit Scale(std::span<const Event> events) : begin_(events.front().first.seconds) {
        PixelBox all;
        double end = begin_;
        for (const Event& event : events) {
            all = bounding_box(all, event.box);
            begin_ = std::min(begin_, event.first.seconds);
            end = std::max(end, event.last.seconds);
        }
        left_ = all.left;
        top_ = all.top;
        side_ = std::max({all.width(), all.height(), 1});
        span_ = std::max(end - begin_, 1e-9);
    }

    /// Clamped so that the last moment lies within the cells.
    double time(double seconds) const { return widths_of_time * std::min((seconds - begin_) / span_, 1 - 1e-9); }

    glm::dvec3 operator()(double x, double y, double seconds) const {
        return {(x - left_) / side_, (y - top_) / side_, time(seconds)};
    }

  private:
    double begin_;
    double span_;
    double left_;
    double top_;
    double side_;
};

/// The size of an object, field pixels.
Size size_of(const Event& event) {
    if (event.portrait) return event.portrait->box.size();
    return event.stays.empty() ? Size{1, 1} : event.stays.front().box.size();
}

/// The cells that an event passes, sorted, each once.
std::vector<std::size_t> way_of(const Event& event, const Scale& scale, const Cells& cells, double step) {
    std::vector<std::size_t> way;
    const Size size = size_of(event);
    const auto cover = [&](const glm::dvec2& place, double seconds) {
        cells.reach(scale(place.x - 0.5 * size.width, place.y - 0.5 * size.height, seconds),
                    scale(place.x + 0.5 * size.width, place.y + 0.5 * size.height, seconds), way);
    };
    if (event.path.empty()) {
        cells.reach(scale(event.box.left, event.box.top, event.first.seconds),
                    scale(event.box.right, event.box.bottom, event.last.seconds), way);
    }
    for (std::size_t k = 0; k < event.path.size(); ++k) {
        const PathPoint& to = event.path[k];
        const PathPoint& from = event.path[k == 0 ? 0 : k - 1];
        const glm::dvec3 gone =
            scale(to.place.x, to.place.y, to.at.seconds) - scale(from.place.x, from.place.y, from.at.seconds);
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(gone) / step)));
        for (int n = 1; n <= steps; ++n) {
            const double part = static_cast<double>(n) / steps;
            cover(glm::mix(from.place, to.place, part), std::lerp(from.at.seconds, to.at.seconds, part));
        }
    }
    std::ranges::sort(way);
    way.erase(std::unique(way.begin(), way.end()), way.end());
    return way;
}

/// Indices of the events by their first frames.
std::vector<std::size_t> by_begin(std::span<const Event> events) {
    std::vector<std::size_t> order(events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return events[k].first.seconds; });
    return order;
}

/// How a colour was used before an event begins.
struct ColourUse {
    double until = -std::numeric_limits<double>::infinity();  ///< when the last object with it goes, seconds
    std::optional<std::size_t> latest;  ///< the last object with it, counted by their first frames
};

// A colour isn't used again for so many objects, if possible.
constexpr std::size_t apart = 4;

// Cells per width of the scene. Events closer than a near cell are neighbours; events farther apart than a far cell are
// not.
constexpr int near_cells = 12;
constexpr int far_cells = 4;

}  // namespace

std::vector<int> colours_of(std::span<const Event> events) {
    std::vector<int> colours(events.size());
    if (events.empty()) return colours;
    const Scale scale(events);
    Cells near(near_cells);
    Cells far(far_cells);
    std::array<ColourUse, object_colours> uses;
    const std::vector<std::size_t> order = by_begin(events);
    for (std::size_t place = 0; place < order.size(); ++place) {
        const Event& event = events[order[place]];
        const std::vector<std::size_t> near_way = way_of(event, scale, near, 0.5 / near_cells);
        const std::vector<std::size_t> far_way = way_of(event, scale, far, 0.5 / far_cells);
        const Cells::Counts neighbours = near.about(near_way);
        const Cells::Counts beyond = far.about(far_way);
        const auto cost = [&](std::size_t c) {
            const ColourUse& use = uses[c];
            const bool at_once = use.until >= event.first.seconds;
            const bool just_before = use.latest && place - *use.latest <= apart;
            // Of equally good ones, the one that was not used for longest.
            const std::size_t since = use.latest ? *use.latest + 1 : 0;
            return std::tuple(at_once, just_before, neighbours[c], beyond[c], since);
        };
        std::size_t best = 0;
        for (std::size_t c = 1; c < uses.size(); ++c) {
            if (cost(c) < cost(best)) best = c;
        }
        near.add(near_way, best);
        far.add(far_way, best);
        uses[best] = {std::max(uses[best].until, event.last.seconds), place};
        colours[order[place]] = static_cast<int>(best);
    }
    return colours;
}

}  // namespace vvr::tracking
