#include "core/volume/owners.h"

#include <algorithm>

namespace vvr::volume {

namespace {

// In field pixels.
constexpr int owner_reach = 3;

}  // namespace

std::uint16_t Owners::number_of(std::size_t track) {
    if (const auto known = numbers_.find(track); known != numbers_.end()) return known->second;
    if (room() == 0) return 0;
    std::uint16_t number = 0;
    if (free_.empty()) {
        tracks_.push_back(track);
        number = static_cast<std::uint16_t>(tracks_.size());
    } else {
        number = free_.back();
        free_.pop_back();
        tracks_[number - std::size_t{1}] = track;
    }
    numbers_.emplace(track, number);
    return number;
}

void Owners::keep_only(const std::vector<bool>& used) {
    std::erase_if(numbers_, [&](const auto& known) {
        const std::uint16_t number = known.second;
        if (number < used.size() && used[number]) return false;
        free_.push_back(number);
        return true;
    });
    // Sorted, so that the next number doesn't depend on the order of a hash table.
    std::ranges::sort(free_, std::greater{});
}

OwnerPlane Owners::pixels_of(std::span<const fields::LabelRun> runs, const SparsePlane& scalar) {
    const Size size = scalar.size();
    OwnerPlane pixels(size);
    if (runs.empty()) return pixels;
    if (whole_.size() != size) whole_ = Plane<std::uint16_t>(size);
    for (const fields::LabelRun& run : runs) {
        const std::uint16_t number = number_of(run.track);
        std::ranges::fill(whole_.row(run.row).subspan(static_cast<std::size_t>(run.first),
                                                      static_cast<std::size_t>(run.last - run.first)),
                          number);
    }
    // Each round extends owners by one pixel. If several reach a pixel in the same round, the first in row-major order
    // gets it.
    struct Found {
        int column;
        int row;
        std::uint16_t number;
    };
    std::vector<Found> found;
    for (int round = 0; round < owner_reach; ++round) {
        found.clear();
        scalar.for_each_run([&](int column, int row, std::span<const std::uint8_t> values) {
            for (const std::uint8_t value : values) {
                if (value != 0 && whole_.at(column, row) == 0) {
                    const int left = std::max(column - 1, 0);
                    const int right = std::min(column + 1, size.width - 1);
                    std::uint16_t near = 0;
                    for (int j = std::max(row - 1, 0); near == 0 && j <= std::min(row + 1, size.height - 1); ++j) {
                        for (int i = left; near == 0 && i <= right; ++i) near = whole_.at(i, j);
                    }
                    if (near != 0) found.push_back({column, row, near});
                }
                ++column;
            }
        });
        for (const Found& pixel : found) whole_.at(pixel.column, pixel.row) = pixel.number;
        if (found.empty()) break;
    }
    scalar.for_each_run([&](int column, int row, std::span<const std::uint8_t> values) {
        for (const std::uint8_t value : values) {
            if (value != 0) pixels.set(column, row, whole_.at(column, row));
            whole_.at(column, row) = 0;
            ++column;
        }
    });
    // Runs may include pixels that are 0 in the field.
    for (const fields::LabelRun& run : runs) {
        std::ranges::fill(whole_.row(run.row).subspan(static_cast<std::size_t>(run.first),
                                                      static_cast<std::size_t>(run.last - run.first)),
                          std::uint16_t{0});
    }
    return pixels;
}

}  // namespace vvr::volume
