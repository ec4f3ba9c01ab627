#include "core/space/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace vvr::space {

namespace {

/// The smallest interval that contains everything added.
struct Bounds {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value_low, double value_high) {
        low = std::min(low, value_low);
        high = std::max(high, value_high);
    }
    double centre() const { return (low + high) / 2; }
    double half() const { return (high - low) / 2; }
};

}  // namespace

glm::dvec2 Camera::pixel(const glm::dvec3& p, Size picture) const {
    const glm::dvec4 clip = clip_from_p() * glm::dvec4(p, 1);
    return {(clip.x / clip.w + 1) / 2 * picture.width, (1 - clip.y / clip.w) / 2 * picture.height};
}

double Camera::pixel_size(const glm::dvec3& p, Size picture) const {
    const double depth = perspective ? glm::dot(p - eye, forward) : 1;
    return 2 * depth / (projection[1][1] * picture.height);
}

Camera Camera::cropped(const PixelBox& part, Size picture) const {
    const glm::dvec2 scale = {static_cast<double>(picture.width) / part.width(),
                              static_cast<double>(picture.height) / part.height()};
    const glm::dvec2 middle = {(part.left + part.right) / static_cast<double>(picture.width) - 1,
                               1 - (part.top + part.bottom) / static_cast<double>(picture.height)};
    glm::dmat4 crop(1);
    crop[0][0] = scale.x;
    crop[1][1] = scale.y;
    crop[3][0] = -middle.x * scale.x;
    crop[3][1] = -middle.y * scale.y;
    Camera camera = *this;
    camera.projection = crop * projection;
    return camera;
}

Camera Camera::within(const PixelBox& part, Size picture) const {
    const glm::dvec2 scale = {static_cast<double>(part.width()) / picture.width,
                              static_cast<double>(part.height()) / picture.height};
    glm::dmat4 place(1);
    place[0][0] = scale.x;
    place[1][1] = scale.y;
    place[3][0] = (part.left + part.right) / static_cast<double>(picture.width) - 1;
    place[3][1] = 1 - (part.top + part.bottom) / static_cast<double>(picture.height);
    Camera camera = *this;
    camera.projection = place * projection;
    return camera;
}

Camera fit_camera(const View& view, std::span<const glm::dvec3> points, Size picture) {
    const double azimuth = glm::radians(view.azimuth);
    const double elevation = glm::radians(view.elevation);
    Camera camera;
    camera.perspective = view.fov > 0;
    camera.forward = {-std::sin(azimuth) * std::cos(elevation), -std::sin(elevation),
                      std::cos(azimuth) * std::cos(elevation)};
    // For vertical views, the azimuth defines the picture's up direction.
    const glm::dvec3 right = {std::cos(azimuth), 0, std::sin(azimuth)};
    const glm::dvec3 up = glm::cross(camera.forward, right);

    const double aspect = static_cast<double>(picture.width) / picture.height;
    const double free = 1 - 2 * view.margin;
    const double tan_y = std::tan(glm::radians(view.fov) / 2) * free;
    const double tan_x = tan_y * aspect;

    // A point (x, y, z) is visible at distance D if |x - cx| <= (z + D) tan_x, and likewise for y: two half-planes per
    // point and axis. The tightest ones give centre and distance directly.
    Bounds x;
    Bounds y;
    Bounds z;
    for (const glm::dvec3& point : points) {
        const glm::dvec3 q = {glm::dot(point, right), glm::dot(point, up), glm::dot(point, camera.forward)};
        x.add(q.x + q.z * tan_x, q.x - q.z * tan_x);
        y.add(q.y + q.z * tan_y, q.y - q.z * tan_y);
        z.add(q.z, q.z);
    }
    const double reach = std::max({x.half(), y.half(), z.half(), 1e-9});
    double distance = 2 * reach - z.low;
    if (camera.perspective) distance = std::max({x.half() / tan_x, y.half() / tan_y, 1e-9 - z.low});
    const glm::dvec3 at = x.centre() * right + y.centre() * up;
    camera.eye = at - distance * camera.forward;

    glm::dmat4 turn(1);
    for (int i = 0; i < 3; ++i) {
        turn[i][0] = right[i];
        turn[i][1] = up[i];
        turn[i][2] = camera.forward[i];
    }
    camera.view = glm::translate(turn, -camera.eye);

    const double eye_z = glm::dot(camera.eye, camera.forward);
    // Arrows may extend beyond the points.
    const double far = z.high - eye_z + 0.3 * reach;
    if (camera.perspective) {
        const double near = std::max(z.low - eye_z - 0.3 * reach, far * 1e-3);
        camera.projection = glm::perspectiveLH_NO(glm::radians(view.fov), aspect, near, far);
    } else {
        const double half = std::max({y.half(), x.half() / aspect, 1e-9}) / free;
        camera.projection = glm::orthoLH_NO(-half * aspect, half * aspect, -half, half, 0.0, far);
    }
    return camera;
}

}  // namespace vvr::space
