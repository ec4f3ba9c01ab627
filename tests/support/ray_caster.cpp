#include "tests/support/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vvr::test {

namespace {

double texel(const volume::Volume& volume, std::int64_t x, std::int64_t y, std::int64_t t) {
    const std::int64_t width = volume.size().width;
    const std::int64_t height = volume.size().height;
    x = std::clamp<std::int64_t>(x, 0, width - 1);
    y = std::clamp<std::int64_t>(y, 0, height - 1);
    t = std::clamp<std::int64_t>(t, 0, volume.layers() - 1);
    return volume.layer(t).scalar.at(static_cast<int>(width - 1 - x), static_cast<int>(height - 1 - y));
}

double interpolate(const volume::Volume& volume, const glm::dvec3& c) {
    const glm::dvec3 at = {c.x * volume.size().width - 0.5, c.y * volume.size().height - 0.5,
                           c.z * static_cast<double>(volume.layers()) - 0.5};
    const glm::dvec3 low = glm::floor(at);
    const glm::dvec3 share = at - low;
    double value = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1;
        const int dy = corner >> 1 & 1;
        const int dt = corner >> 2;
        const double weight =
            (dx ? share.x : 1 - share.x) * (dy ? share.y : 1 - share.y) * (dt ? share.z : 1 - share.z);
        value += weight * texel(volume, static_cast<std::int64_t>(low.x) + dx, static_cast<std::int64_t>(low.y) + dy,
                                static_cast<std::int64_t>(low.z) + dt);
    }
    return value;
}

/// What is seen at the centre of a pixel, from the nearest to the farthest point.
struct Ray {
    glm::dvec3 begin;
    glm::dvec3 way;

    Ray(int i, int j, Size picture, const glm::dmat4& p_from_clip) {
        const glm::dvec2 at = {(i + 0.5) / picture.width * 2 - 1, 1 - (j + 0.5) / picture.height * 2};
        const glm::dvec4 near = p_from_clip * glm::dvec4(at, -1, 1);
        const glm::dvec4 far = p_from_clip * glm::dvec4(at, 1, 1);
        begin = glm::dvec3(near) / near.w;
        way = glm::dvec3(far) / far.w - begin;
    }
};

std::vector<double> sorted_differences(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b) {
    if (a.size() != b.size() || a.empty()) throw std::logic_error("the pictures differ in size or are empty");
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            differences.push_back(255.0 * std::abs(a.pixels()[i][channel] - b.pixels()[i][channel]));
        }
    }
    std::ranges::sort(differences);
    return differences;
}

}  // namespace

Plane<glm::vec4> cast_rays(const volume::Volume& volume, const space::Layout& layout,
                           const scene::TransferFunction& transfer, const space::Camera& camera, Size picture,
                           const glm::dvec3& background, double step) {
    const glm::dmat4 p_from_clip = glm::inverse(camera.clip_from_p());
    Plane<glm::vec4> result(picture);
    for (int j = 0; j < picture.height; ++j) {
        for (int i = 0; i < picture.width; ++i) {
            const auto [begin, way] = Ray(i, j, picture, p_from_clip);
            const double length = glm::length(way);

            glm::dvec3 colour{0};
            double through = 1;
            for (double s = step / 2; s < length; s += step) {
                const glm::dvec3 c = layout.c_from_p(begin + way * (s / length));
                if (glm::any(glm::lessThan(c, glm::dvec3(0))) || glm::any(glm::greaterThan(c, glm::dvec3(1)))) continue;
                const glm::dvec4 optical = transfer.at(interpolate(volume, c));
                const double opacity = 1 - std::exp(-optical.w * step);
                colour += through * opacity * glm::dvec3(optical);
                through *= 1 - opacity;
            }
            result.at(i, j) = glm::vec4(glm::vec3(colour + through * background), 1);
        }
    }
    return result;
}

glm::dvec3 c_of_pixel(int i, int j, double depth, const space::Camera& camera, const space::Layout& layout,
                      Size picture) {
    const auto [begin, way] = Ray(i, j, picture, glm::inverse(camera.clip_from_p()));
    const double share = (depth - glm::dot(begin - camera.eye, camera.forward)) / glm::dot(way, camera.forward);
    return layout.c_from_p(begin + share * way);
}

double mean_difference(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b) {
    double sum = 0;
    const std::vector<double> differences = sorted_differences(a, b);
    for (const double difference : differences) sum += difference;
    return sum / static_cast<double>(differences.size());
}

double quantile_difference(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b, double share) {
    const std::vector<double> differences = sorted_differences(a, b);
    return differences[static_cast<std::size_t>((1 - share) * static_cast<double>(differences.size() - 1))];
}

double max_difference(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b) {
    return sorted_differences(a, b).back();
}

double max_contrast(const Plane<glm::vec4>& picture) {
    return max_difference(picture, Plane<glm::vec4>(picture.size(), glm::vec4(1)));
}

}  // namespace vvr::test
