#include "core/fields/seeds.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/setting.h"

namespace vvr::fields {
namespace {

float magnitude(const SeedInput& input, int i, int j) {
    return std::hypot(input.flow.u.at(i, j), input.flow.v.at(i, j));
}

constexpr std::array orders{
    SeedOrderRow{"magnitude", "fastest first", false, magnitude},
    SeedOrderRow{"difference", "largest difference from the empty scene first", false,
                 [](const SeedInput& input, int i, int j) { return static_cast<float>(input.object.at(i, j)); }},
    SeedOrderRow{"age", "longest present first", true,
                 [](const SeedInput& input, int i, int j) { return static_cast<float>(input.age.at(i, j)); }},
};

constexpr std::array areas{
    SeedAreaRow{"object", "on moving objects", true},
    SeedAreaRow{"field", "anywhere in the frame, as in the paper", false},
};

/// A seed and its sort key.
struct Candidate {
    Seed seed;
    float weight;
};

std::vector<Candidate> eligible(const SeedInput& input, const SeedOptions& options) {
    std::vector<Candidate> result;
    for (int j = options.grid / 2; j < input.object.height(); j += options.grid) {
        for (int i = options.grid / 2; i < input.object.width(); i += options.grid) {
            if (options.area->object_alone && input.object.at(i, j) == 0) continue;
            if (!(magnitude(input, i, j) >= options.min_magnitude)) continue;
            const Seed seed{static_cast<float>(i), static_cast<float>(j), input.flow.u.at(i, j), input.flow.v.at(i, j)};
            result.push_back({seed, options.order->weight(input, i, j)});
        }
    }
    return result;
}

/// SplitMix64 (Steele, Lea and Flood 2014). The standard library's distributions differ between implementations, but a
/// seed number must give the same points everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t operator()() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }

  private:
    std::uint64_t state_;
};

/// Selects `count` candidates uniformly at random, in their order (Knuth, algorithm S).
std::vector<Candidate> some_of(const std::vector<Candidate>& all, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Candidate> taken;
    for (std::size_t k = 0; k < all.size() && taken.size() < count; ++k) {
        if (random() % (all.size() - k) < count - taken.size()) taken.push_back(all[k]);
    }
    return taken;
}

template <class Number>
bool parse_whole(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::span<const SeedOrderRow> seed_orders() {
    return orders;
}

std::span<const SeedAreaRow> seed_areas() {
    return areas;
}

Plane<std::uint16_t> aged(const Plane<std::uint16_t>& before, const Plane<std::uint8_t>& object) {
    auto age = Plane<std::uint16_t>::for_overwrite(object.size());
    for (std::size_t i = 0; i < age.pixels().size(); ++i) {
        const int then = before.empty() ? 0 : before.pixels()[i];
        const int most = std::numeric_limits<std::uint16_t>::max();
        age.pixels()[i] = static_cast<std::uint16_t>(object.pixels()[i] == 0 ? 0 : std::min(then + 1, most));
    }
    return age;
}

SeedSelection parse_seed_selection(const std::string& text) {
    const std::string_view all = text;
    if (all == "all") return {};
    SeedSelection result;
    if (all.starts_with("first:")) {
        result.kind = SeedSelection::Kind::first;
        if (parse_whole(all.substr(6), result.count)) return result;
    }
    if (all.starts_with("random:")) {
        result.kind = SeedSelection::Kind::random;
        const std::size_t colon = std::min(all.find(':', 7), all.size());
        const bool numbered = colon == all.size() || parse_whole(all.substr(colon + 1), result.number);
        if (numbered && parse_whole(all.substr(7, colon - 7), result.count)) return result;
    }
    throw Error(ErrorCode::option_value,
                fmt::format("seed-select: '{}' is not one of: all, first:N, random:N, random:N:NUMBER", text),
                {"seed-select"});
}

std::vector<Seed> make_seeds(const SeedInput& input, const SeedOptions& options) {
    const SeedSelection& selection = options.select;
    std::vector<Candidate> candidates = eligible(input, options);
    std::ranges::stable_sort(candidates, std::ranges::greater{}, &Candidate::weight);
    if (selection.kind == SeedSelection::Kind::random) {
        // The factor differs from the generator's increment. With the same one, neighbouring frames would draw the same
        // numbers, shifted.
        const std::uint64_t seed = selection.number * 0xd1342543de82ef95U + static_cast<std::uint64_t>(input.index);
        candidates = some_of(candidates, selection.count, Random(seed)());
    }
    if (selection.kind == SeedSelection::Kind::first && candidates.size() > selection.count) {
        candidates.resize(selection.count);
    }
    std::vector<Seed> seeds;
    for (const Candidate& candidate : candidates) seeds.push_back(candidate.seed);
    return seeds;
}

const SeedOrderRow& row_of(Name<SeedOrderRow> name) {
    return choose("seed-order", name.text, seed_orders());
}

const SeedAreaRow& row_of(Name<SeedAreaRow> name) {
    return choose("seed-area", name.text, seed_areas());
}

}  // namespace vvr::fields
