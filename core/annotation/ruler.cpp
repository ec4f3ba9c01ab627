#include "core/annotation/ruler.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

namespace vvr::annotation {

namespace {

// Length of a mark, in x_C.
constexpr double mark_length = 0.045;

glm::dvec3 on_edge(const TimeEdge& edge, double t, double out) {
    return {edge.x + (edge.x > 0.5 ? out : -out), edge.y, t};
}

struct Mark {
    glm::dvec3 from;
    glm::dvec3 to;
};

Mark mark_at(const space::Layout& layout, const TimeEdge& edge, double t) {
    return {layout.p_from_c(on_edge(edge, t, 0)), layout.p_from_c(on_edge(edge, t, mark_length))};
}

/// Writes a text at the outer end of the mark at `t`.
void write_beside(const std::string& text, double t, const space::Layout& layout, const TimeEdge& edge,
                  const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering) {
    const auto& [end, out] = mark_in_picture(layout, edge, t, camera, sheet.picture);
    const Label size = make_label(text, sheet.text, 0, 0, colour);
    const double half = (std::abs(out.x) * size.box.width() + std::abs(out.y) * size.box.height()) / 2;
    const glm::dvec2 middle = end + out * (half + sheet.text / 3.0);
    lettering.add(make_centred_label(text, sheet.text, middle.x, middle.y, colour), sheet.between, sheet.text / 2);
}

}  // namespace

MarkInPicture mark_in_picture(const space::Layout& layout, const TimeEdge& edge, double t, const space::Camera& camera,
                              Size picture) {
    const Mark mark = mark_at(layout, edge, t);
    const glm::dvec2 end = camera.pixel(mark.to, picture);
    const glm::dvec2 out = end - camera.pixel(mark.from, picture);
    return {end, glm::length(out) > 1e-6 ? glm::normalize(out) : glm::dvec2(0, -1)};
}

TimeEdge outer_edge(const space::Layout& layout, const space::Camera& camera, Size picture) {
    constexpr int samples = 32;
    const glm::dvec2 middle = {picture.width / 2.0, picture.height / 2.0};
    TimeEdge best;
    double farthest = -1;
    for (const TimeEdge edge : {TimeEdge{1, 1}, TimeEdge{0, 1}, TimeEdge{1, 0}, TimeEdge{0, 0}}) {
        double sum = 0;
        for (int i = 0; i <= samples; ++i) {
            const glm::dvec3 p = layout.p_from_c(on_edge(edge, static_cast<double>(i) / samples, 0));
            sum += glm::length(camera.pixel(p, picture) - middle);
        }
        // Ties, up to rounding, go to the earlier edge.
        if (sum <= farthest * 1.001) continue;
        farthest = sum;
        best = edge;
    }
    return best;
}

std::vector<glm::dvec3> ruler_reach(const space::Layout& layout, const TimeEdge& edge) {
    constexpr int samples = 64;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= samples; ++i) points.push_back(mark_at(layout, edge, static_cast<double>(i) / samples).to);
    return points;
}

std::vector<scene::LineSegment> ruler_marks(const volume::Volume& volume, const space::Layout& layout,
                                            const TimeEdge& edge, const std::vector<TimeTick>& ticks,
                                            const glm::vec4& colour) {
    std::vector<scene::LineSegment> marks;
    for (const TimeTick& tick : ticks) {
        const Mark mark = mark_at(layout, edge, volume.t_of_seconds(tick.seconds));
        marks.push_back({glm::vec3(mark.from), glm::vec3(mark.to), colour});
    }
    return marks;
}

std::vector<TimeGap> time_gaps(const volume::Volume& volume) {
    std::vector<TimeGap> gaps;
    bool within = false;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const volume::Layer& layer = volume.layer(i);
        const bool empty = layer.missing == layer.frames;
        const double share = volume.t_end() / static_cast<double>(volume.layers());
        if (empty && !within) gaps.push_back({share * static_cast<double>(i), 0, layer.pts});
        if (empty) {
            gaps.back().t_end = share * static_cast<double>(i + 1);
            gaps.back().end = layer.last_pts;
        }
        within = empty;
    }
    return gaps;
}

std::vector<scene::LineSegment> gap_marks(const std::vector<TimeGap>& gaps, const space::Layout& layout,
                                          const TimeEdge& edge, const glm::vec4& colour) {
    constexpr double between = 0.006;  // t_C from one stroke to the next
    std::vector<scene::LineSegment> strokes;
    for (const TimeGap& gap : gaps) {
        const int count = std::max(1, static_cast<int>((gap.t_end - gap.t_begin) / between));
        for (int i = 0; i <= count; ++i) {
            const double t = std::lerp(gap.t_begin, gap.t_end, static_cast<double>(i) / count);
            const double leaning = std::clamp(t + between, gap.t_begin, gap.t_end);
            strokes.push_back({glm::vec3(layout.p_from_c(on_edge(edge, t, 0.1 * mark_length))),
                               glm::vec3(layout.p_from_c(on_edge(edge, leaning, 0.9 * mark_length))), colour});
        }
    }
    return strokes;
}

void label_gaps(const std::vector<TimeGap>& gaps, const space::Layout& layout, const TimeEdge& edge,
                const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering) {
    for (const TimeGap& gap : gaps) {
        write_beside(gap.reason, (gap.t_begin + gap.t_end) / 2, layout, edge, camera, sheet, colour, lettering);
    }
}

std::vector<TimeTick> spread_ticks(const volume::Volume& volume, int most, const WallClock& clock) {
    const double begin = volume.layer(0).pts;
    const double end = volume.layer(volume.layers() - 1).last_pts;
    constexpr int max_factor = 1024;
    const double apart = 0.8 * volume.t_end() / most;
    std::vector<std::pair<double, double>> without;  // t_C where a tick would tell little
    for (const volume::CompressedIdle& s : volume::compressed_stretches(volume))
        without.emplace_back(s.t_begin, s.t_end);
    for (const TimeGap& gap : time_gaps(volume)) without.emplace_back(gap.t_begin, gap.t_end);
    std::vector<TimeTick> kept;
    const auto keep = [&](TimeTick tick) {
        const double t = volume.t_of_seconds(tick.seconds);
        const bool tells =
            std::ranges::none_of(without, [&](const auto& s) { return s.first < t && t < s.second - 1e-9; });
        const bool free = std::ranges::none_of(
            kept, [&](const TimeTick& other) { return std::abs(volume.t_of_seconds(other.seconds) - t) < apart; });
        if (tells && free) kept.push_back(std::move(tick));
    };
    for (int factor = 1; factor <= max_factor; factor *= 2) {
        for (TimeTick& tick : time_ticks(begin, end, factor * most, clock)) {
            const bool whole = tick.seconds == std::floor(tick.seconds) || end - begin < most;
            if (whole) keep(std::move(tick));
        }
    }
    // No round time may be in the footage of a camera that records only motion.
    const auto is_gap = [&](std::int64_t i) { return volume.layer(i).missing == volume.layer(i).frames; };
    for (std::int64_t i = 1; i < volume.layers(); ++i) {
        const double seconds = volume.layer(i).pts;
        if (is_gap(i - 1) && !is_gap(i)) keep({seconds, format_moment_and_day(seconds, clock)});
    }
    std::ranges::sort(kept, {}, &TimeTick::seconds);
    return kept;
}

std::vector<TimeBreak> time_breaks(const volume::Volume& volume, std::size_t most) {
    std::vector<TimeBreak> breaks;
    for (const volume::CompressedIdle& stretch : volume::compressed_stretches(volume)) {
        breaks.push_back({(stretch.t_begin + stretch.t_end) / 2, stretch.seconds});
    }
    std::ranges::stable_sort(breaks, std::greater{}, &TimeBreak::seconds);
    if (breaks.size() > most) breaks.resize(most);
    std::ranges::sort(breaks, {}, &TimeBreak::t);
    return breaks;
}

std::vector<scene::LineSegment> break_marks(const std::vector<TimeBreak>& breaks, const space::Layout& layout,
                                            const TimeEdge& edge, const glm::vec4& colour) {
    constexpr double lean = 0.004;  // in t_C
    constexpr double across = 0.5 * mark_length;
    std::vector<scene::LineSegment> strokes;
    for (const TimeBreak& gap : breaks) {
        for (const double t : {gap.t - lean / 2, gap.t + lean / 2}) {
            strokes.push_back({glm::vec3(layout.p_from_c(on_edge(edge, std::max(0.0, t - lean / 2), -across))),
                               glm::vec3(layout.p_from_c(on_edge(edge, std::min(1.0, t + lean / 2), across))), colour});
        }
    }
    return strokes;
}

void label_breaks(const std::vector<TimeBreak>& breaks, const space::Layout& layout, const TimeEdge& edge,
                  const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering) {
    std::vector<TimeBreak> longest = breaks;
    std::ranges::stable_sort(longest, std::greater{}, &TimeBreak::seconds);
    for (const TimeBreak& gap : longest) {
        if (gap.seconds < longest.front().seconds / 50) break;  // short breaks would only distract
        write_beside(fmt::format("{} idle", format_duration(gap.seconds)), gap.t, layout, edge, camera, sheet, colour,
                     lettering);
    }
}

void label_ticks(const volume::Volume& volume, const space::Layout& layout, const TimeEdge& edge,
                 std::span<const TimeTick> ticks, const space::Camera& camera, const Sheet& sheet,
                 const image::Rgba& colour, Lettering& lettering) {
    for (const TimeTick& tick : ticks) {
        write_beside(tick.text, volume.t_of_seconds(tick.seconds), layout, edge, camera, sheet, colour, lettering);
    }
}

bool is_uneven(const volume::Volume& volume) {
    if (!volume.is_nonuniform()) return false;
    constexpr int samples = 32;
    constexpr double visible = 0.02;  // of the whole edge
    const double begin = volume.layer(0).pts;
    const double end = volume.layer(volume.layers() - 1).last_pts;
    for (int i = 1; i < samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const double t = volume.t_of_seconds(std::lerp(begin, end, share));
        if (std::abs(t / volume.t_end() - share) > visible) return true;
    }
    return false;
}

}  // namespace vvr::annotation
