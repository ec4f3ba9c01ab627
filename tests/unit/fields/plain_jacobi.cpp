#include "tests/unit/fields/plain_jacobi.h"

#include <utility>

namespace vvr::test {
namespace {

float mean(const float* p, int width, int height, int i, int j) {
    const int left = i > 0 ? i - 1 : 0;
    const int right = i < width - 1 ? i + 1 : i;
    const float* const above = p + (j > 0 ? j - 1 : 0) * width;
    const float* const here = p + j * width;
    const float* const below = p + (j < height - 1 ? j + 1 : j) * width;
    return (above[i] + below[i] + here[left] + here[right]) / 6 +
           (above[left] + above[right] + below[left] + below[right]) / 12;
}

}  // namespace

fields::Flow plain_jacobi(const Plane<float>& ix, const Plane<float>& iy, const Plane<float>& it, float alpha,
                          int steps) {
    const int width = ix.width();
    const int height = ix.height();
    fields::Flow flow{Plane<float>(ix.size()), Plane<float>(ix.size())};
    fields::Flow next = flow;
    const float* const dx = ix.pixels().data();
    const float* const dy = iy.pixels().data();
    const float* const dt = it.pixels().data();
    for (int step = 0; step < steps; ++step) {
        const float* const u = flow.u.pixels().data();
        const float* const v = flow.v.pixels().data();
        float* const next_u = next.u.pixels().data();
        float* const next_v = next.v.pixels().data();
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                const int k = j * width + i;
                const float mean_u = mean(u, width, height, i, j);
                const float mean_v = mean(v, width, height, i, j);
                const float error =
                    (dx[k] * mean_u + dy[k] * mean_v + dt[k]) / (alpha * alpha + dx[k] * dx[k] + dy[k] * dy[k]);
                next_u[k] = mean_u - dx[k] * error;
                next_v[k] = mean_v - dy[k] * error;
            }
        }
        std::swap(flow, next);
    }
    return flow;
}

}  // namespace vvr::test
