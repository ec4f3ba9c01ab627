#include "core/scene/reduced_volume.h"

#include <algorithm>
#include <cmath>

#include "core/scene/theme.h"

namespace vvr::scene {

namespace {

constexpr std::uint16_t most_numbers = 0xFFFF / 4;

/// The scalars of the levels, from the lowest visible one to 255.
std::array<std::uint8_t, reduced_levels> values_of_levels(const TransferFunction& transfer) {
    int low = 1;
    while (low < 255 && !(transfer.at(low).w > 0)) ++low;
    std::array<std::uint8_t, reduced_levels> values{};
    for (int level = 1; level < reduced_levels; ++level) {
        const double share = std::pow(static_cast<double>(level) / (reduced_levels - 1), 1.5);
        values.at(static_cast<std::size_t>(level)) = static_cast<std::uint8_t>(std::lround(std::lerp(low, 255, share)));
    }
    return values;
}

/// What a block has so far.
struct Gathered {
    float extinction = 0;  ///< sum over its voxels
    float lead = 0;        ///< of `owner` before all others
    std::uint16_t owner = 0;

    /// The owner of more than half of the extinction wins, whatever the order.
    void add(std::uint16_t of, float part) {
        extinction += part;
        if (of == owner) {
            lead += part;
        } else if ((lead -= part) < 0) {
            owner = of;
            lead = -lead;
        }
    }
};

/// Adds up the extinction of a volume's voxels, layer by layer.
class Gatherer {
  public:
    Gatherer(const volume::Volume& volume, const Block& block, const TransferFunction& transfer,
             std::span<const glm::vec4> palette, const volume::VoxelStyleLookup& identify, Size size)
        : volume_(volume), palette_(palette), identify_(identify), block_(block), gathered_(size) {
        for (int value = 0; value < 256; ++value)
            extinction_.at(static_cast<std::size_t>(value)) = static_cast<float>(transfer.at(value).w);
    }

    void add(const volume::Layer& layer) {
        const Size size = volume_.size();
        std::uint16_t known = 0;
        volume::VoxelStyle style;
        layer.scalar.for_each_run([&](int column, int row, std::span<const std::uint8_t> values) {
            const auto into = gathered_.row((size.height - 1 - row) / block_.side);
            for (const std::uint8_t value : values) {
                const int i = column++;
                if (!(extinction_.at(value) > 0)) continue;
                const std::uint16_t owner = layer.owner.empty() ? std::uint16_t{0} : layer.owner.at(i, row);
                if (owner != known) {
                    known = owner;
                    style = owner == 0 || !identify_ ? volume::VoxelStyle{} : identify_(volume_.track_of(owner), layer);
                }
                const bool numbered = style.number > 0 && style.number <= most_numbers;
                const auto code = static_cast<std::uint16_t>(
                    numbered ? style.number * 4 + static_cast<int>(state_of(style.look)) : 0);
                into[static_cast<std::size_t>((size.width - 1 - i) / block_.side)].add(
                    code, extinction_.at(value) * palette_[style.look].a);
            }
        });
    }

    /// Moves what was gathered to the end of a reduced volume.
    void flush(std::span<const glm::vec4> palette, ReducedVolume& into) {
        const auto voxels = static_cast<float>(block_.side * block_.side * block_.depth);
        for (Gathered& of : gathered_.pixels()) {
            const float factor =
                of.owner == 0 ? palette.front().a : palette[palette_index(0, static_cast<ObjectState>(of.owner % 4))].a;
            const std::uint8_t level = of.extinction > 0 && factor > 0
                                           ? level_of(of.extinction / voxels / factor, into.values)
                                           : std::uint8_t{0};
            into.levels.push_back(level);
            if (level > 0) into.owners.push_back(of.owner);
            of = {};
        }
    }

  private:
    /// The level whose extinction is nearest.
    std::uint8_t level_of(float extinction, const std::array<std::uint8_t, reduced_levels>& values) const {
        const auto best = std::ranges::min_element(values, {}, [&](std::uint8_t value) {
            return std::abs((value > 0 ? extinction_.at(value) : 0) - extinction);
        });
        return static_cast<std::uint8_t>(best - values.begin());
    }

    const volume::Volume& volume_;
    std::span<const glm::vec4> palette_;
    const volume::VoxelStyleLookup& identify_;
    Block block_;
    std::array<float, 256> extinction_{};
    Plane<Gathered> gathered_;
};

}  // namespace

ReducedVolume reduced(const volume::Volume& volume, const Block& block, const TransferFunction& transfer,
                      std::span<const glm::vec4> palette, const volume::VoxelStyleLookup& identify) {
    const auto blocks = [](auto count, auto length) { return (count + length - 1) / length; };
    ReducedVolume into;
    into.block = block;
    into.size = {blocks(volume.size().width, block.side), blocks(volume.size().height, block.side)};
    into.layers = blocks(volume.layers(), block.depth);
    into.values = values_of_levels(transfer);
    Gatherer gatherer(volume, block, transfer, palette, identify, into.size);
    for (std::int64_t layer = 0; layer < volume.layers(); ++layer) {
        gatherer.add(volume.layer(layer));
        if ((layer + 1) % block.depth == 0 || layer + 1 == volume.layers()) gatherer.flush(palette, into);
    }
    return into;
}

}  // namespace vvr::scene
