#include "core/labels/ruler.h"

#include <algorithm>
#include <cmath>

namespace vvr {

namespace {

// How far a mark sticks out, in x_C.
constexpr double mark_length = 0.045;

glm::dvec3 on_edge(const TimeEdge& edge, double t, double out) {
    return {edge.x + (edge.x > 0.5 ? out : -out), edge.y, t};
}

struct Mark {
    glm::dvec3 from;
    glm::dvec3 to;
};

Mark mark_at(const Layout& layout, const TimeEdge& edge, double t) {
    return {layout.p_from_c(on_edge(edge, t, 0)), layout.p_from_c(on_edge(edge, t, mark_length))};
}

}  // namespace

TimeEdge outer_edge(const Layout& layout, const Camera& camera, Size picture) {
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
        // Edges that are as far out as another, but for rounding, come after it.
        if (sum <= farthest * 1.001) continue;
        farthest = sum;
        best = edge;
    }
    return best;
}

std::vector<glm::dvec3> ruler_reach(const Layout& layout, const TimeEdge& edge) {
    constexpr int samples = 64;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= samples; ++i) points.push_back(mark_at(layout, edge, static_cast<double>(i) / samples).to);
    return points;
}

std::vector<Segment> ruler_marks(const Volume& volume, const Layout& layout, const TimeEdge& edge,
                                 const std::vector<TimeTick>& ticks, const glm::vec4& colour) {
    std::vector<Segment> marks;
    for (const TimeTick& tick : ticks) {
        const Mark mark = mark_at(layout, edge, volume.t_of_seconds(tick.seconds));
        marks.push_back({glm::vec3(mark.from), glm::vec3(mark.to), colour});
    }
    return marks;
}

void letter_ruler(const Volume& volume, const Layout& layout, const TimeEdge& edge, const std::vector<TimeTick>& ticks,
                  const Camera& camera, const Sheet& sheet, const Rgba& colour, Lettering& lettering) {
    const auto write = [&](const TimeTick& tick) {
        const Mark mark = mark_at(layout, edge, volume.t_of_seconds(tick.seconds));
        const glm::dvec2 end = camera.pixel(mark.to, sheet.picture);
        glm::dvec2 way = end - camera.pixel(mark.from, sheet.picture);
        way = glm::length(way) > 1e-6 ? glm::normalize(way) : glm::dvec2(0, -1);
        const Label size = make_label(tick.text, sheet.text, 0, 0, colour);
        const double half = (std::abs(way.x) * size.box.width() + std::abs(way.y) * size.box.height()) / 2;
        const glm::dvec2 middle = end + way * (half + sheet.text / 3.0);
        lettering.add(make_label_around(tick.text, sheet.text, middle.x, middle.y, colour), sheet.between,
                      sheet.text / 2);
    };
    if (ticks.empty()) return;
    write(ticks.front());
    if (ticks.size() > 1) write(ticks.back());
    for (std::size_t i = 1; i + 1 < ticks.size(); ++i) write(ticks[i]);
}

}  // namespace vvr
