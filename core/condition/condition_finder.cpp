#include "core/condition/condition_finder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "core/condition/thresholds.h"

namespace vvr::condition {

namespace {

constexpr int step = 3;  // pixels between two samples

/// Mean difference, levels.
double difference_of(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(1, a.size()));
}

/// Adds a value to the last few.
template <class Value>
void keep(const Value& value, std::size_t most, std::deque<Value>& values) {
    values.push_back(value);
    if (values.size() > most) values.pop_front();
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The largest share of samples within three levels of one.
double flat_share(const std::vector<std::uint8_t>& samples) {
    constexpr int reach = 3;
    std::array<std::int64_t, 256 + 2 * reach> counts{};
    for (const std::uint8_t level : samples) ++counts[static_cast<std::size_t>(level + reach)];
    std::int64_t most = 0;
    for (auto first = counts.begin(); first + 2 * reach < counts.end(); ++first) {
        std::int64_t sum = 0;
        for (auto level = first; level <= first + 2 * reach; ++level) sum += *level;
        most = std::max(most, sum);
    }
    return static_cast<double>(most) / static_cast<double>(std::max<std::size_t>(1, samples.size()));
}

/// Whether a picture shows the view of one shortly before.
bool goes_on(const EdgeMap& now, const EdgeMap& before) {
    const Agreement found = agreement(now, before);
    return found.blocks >= thresholds.fewest_blocks && shows(found);
}

/// What a frame that shows no known view shows.
Kind other_than_view(const FrameSigns& now, const Agreement& view) {
    if (is_blank(now)) return Kind::blank;
    return view.contrast < thresholds.covered ? Kind::covered : Kind::turning;
}

}  // namespace

std::vector<std::uint8_t> samples_of(const Plane<std::uint8_t>& plane) {
    std::vector<std::uint8_t> samples;
    for (int j = 0; j < plane.height(); j += step) {
        for (int i = 0; i < plane.width(); i += step) samples.push_back(plane.at(i, j));
    }
    return samples;
}

FrameSigns signs_of(const Plane<std::uint8_t>& grey) {
    FrameSigns signs{samples_of(grey), edge_map(grey)};
    signs.flat = flat_share(signs.samples);
    return signs;
}

bool is_blank(const FrameSigns& signs) {
    return signs.flat >= thresholds.flat;
}

Verdict FreezeFinder::operator()(const std::vector<std::uint8_t>& samples, double seconds) {
    const std::vector<std::uint8_t> before = std::exchange(last_, samples);
    if (before.size() != samples.size() || samples.empty()) return {};
    const double difference = difference_of(samples, before);
    if (difference > thresholds.equal || (!same_since_ && !has_noise())) {
        same_since_.reset();
        note_changes(samples, before);
        keep({seconds, difference}, thresholds.usual, recent_);
        return {};
    }
    if (!same_since_) same_since_ = seconds;
    if (seconds - *same_since_ < thresholds.frozen) return {Kind::normal, true};
    return {Kind::frozen, true, begin()};
}

void FreezeFinder::note_changes(const std::vector<std::uint8_t>& samples, const std::vector<std::uint8_t>& before) {
    const auto strip = static_cast<std::size_t>(thresholds.strip);
    ++count_;
    changed_.resize(samples.size() / strip);
    for (std::size_t k = 0; k < changed_.size(); ++k) {
        const auto first = samples.begin() + static_cast<std::ptrdiff_t>(k * strip);
        const auto other = before.begin() + static_cast<std::ptrdiff_t>(k * strip);
        changed_[k] = changed_[k] << 1 | (std::equal(first, first + thresholds.strip, other) ? 0 : 1);
    }
}

/// Whether all of the picture changed again and again: that is a camera's noise. A codec changes drawn pictures rarely.
bool FreezeFinder::has_noise() const {
    if (count_ < thresholds.fewest) return false;
    const auto noisy =
        std::ranges::count_if(changed_, [](std::uint64_t bits) { return std::popcount(bits) >= thresholds.changes; });
    return static_cast<double>(noisy) >= thresholds.noisy * static_cast<double>(changed_.size());
}

/// When the picture froze: a codec still sharpens it for a while.
double FreezeFinder::begin() const {
    std::vector<double> levels;
    for (const Difference& some : recent_) levels.push_back(some.levels);
    const double usual = thresholds.settled * median_of(std::move(levels));
    double begin = *same_since_;
    for (auto some = recent_.rbegin(); some != recent_.rend() && some->levels <= usual; ++some) {
        if (*same_since_ - some->seconds > thresholds.settling) return *same_since_;  // it was a quiet time
        begin = some->seconds;
    }
    return begin;
}

bool LightFinder::operator()(double level, double seconds) {
    constexpr double lately = 2;    // seconds …
    constexpr double enough = 1.5;  // … of which so many tell what is usual
    if (usual_) {
        const bool is_back = std::abs(level - usual_->level) < thresholds.jump / 2;
        if (!is_back && seconds - usual_->seconds <= thresholds.passing) return true;
        usual_.reset();
        recent_.clear();
    }
    std::vector<double> levels;
    for (const Level& one : recent_) levels.push_back(one.level);
    if (!levels.empty() && seconds - recent_.front().seconds >= enough) {
        const double usual = median_of(std::move(levels));
        if (std::abs(level - usual) >= thresholds.jump) usual_ = {seconds, usual};
    }
    recent_.push_back({seconds, level});
    while (seconds - recent_.front().seconds > lately) recent_.pop_front();
    return usual_.has_value();
}

Verdict ConditionFinder::operator()(const FrameSigns& now, const Agreement& view, double seconds) {
    const Verdict freeze = freeze_(now.samples, seconds);
    return shows_view(now, view, seconds) ? freeze : Verdict{other_than_view(now, view)};
}

/// Whether the camera still shows the view. Light that changes slowly may change most edges in the end, but not within
/// a second.
bool ConditionFinder::shows_view(const FrameSigns& now, const Agreement& view, double seconds) {
    const bool shown = shows(view) || goes_on(now.edges, known_);
    if (shown && seconds - known_at_ >= thresholds.known) {
        known_ = now.edges;
        known_at_ = seconds;
    }
    return shown;
}

}  // namespace vvr::condition
