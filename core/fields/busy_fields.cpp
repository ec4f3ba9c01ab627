#include "core/fields/busy_fields.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <utility>
#include <vector>

#include "core/fields/tiles.h"

namespace vvr {
namespace {

constexpr double memory = 0.4;  // seconds over which something has to have moved
constexpr int moved = 12;       // pixels of a tile's 64 that come or go; the edge of what stands still flickers by less
constexpr std::size_t most_held = 64;  // frames

/// How many pixels of each tile hold something.
std::vector<std::uint8_t> filling(const Plane<std::uint8_t>& scalar) {
    const int columns = (scalar.width() + tile_side - 1) / tile_side;
    const int rows = (scalar.height() + tile_side - 1) / tile_side;
    std::vector<std::uint8_t> counts(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < scalar.height(); ++j) {
        std::uint8_t* const out = counts.data() + static_cast<std::ptrdiff_t>(j / tile_side) * columns;
        const auto row = scalar.row(j);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (row[i] != 0) ++out[i / tile_side];
    }
    return counts;
}

bool differ(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(a[i] - b[i]) >= moved) return true;
    }
    return false;
}

/// Tells of each frame whether anything in it has moved of late.
class Motion {
  public:
    bool operator()(const Field& field) {
        past_.push_back({field.pts, filling(field.scalar)});
        while (past_.size() > 2 && field.pts - past_[1].pts >= memory) past_.pop_front();
        return differ(past_.front().filling, past_.back().filling);
    }

  private:
    struct Past {
        double pts = 0;
        std::vector<std::uint8_t> filling;
    };

    std::deque<Past> past_;
};

}  // namespace

FieldSummary BusyFields::read(const FieldNeeds& needs, const FieldSink& sink) {
    Motion moves;
    std::deque<std::pair<SharedFrame, Field>> held;  // still frames that stay only if something moves soon
    double last_motion = 0;
    std::int64_t given = 0;
    const auto give_held = [&] {
        for (auto& [frame, field] : held) sink(frame, std::move(field));
        given += std::ssize(held);
        held.clear();
    };
    FieldSummary summary = fields_->read(needs, [&](const SharedFrame& frame, Field&& field) {
        const double pts = field.pts;
        if (moves(field) || given == 0) last_motion = pts;
        held.emplace_back(frame, std::move(field));
        if (pts - last_motion <= longest_ / 2) {
            give_held();
        } else if (pts - held.front().second.pts > longest_ / 2 || held.size() > most_held) {
            held.pop_front();
        }
    });
    give_held();
    summary.frames = given;
    return summary;
}

}  // namespace vvr
