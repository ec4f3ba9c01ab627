#pragma once

#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "core/plane.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr {

/// Layout, camera and size of the picture.
struct ViewOptions {
    std::string layout = layouts().front().name;
    std::pair<double, double> radii{LayoutOptions{}.r_min, LayoutOptions{}.r_max};  ///< inner, outer
    std::optional<double> height;              ///< none = square pixels
    Size size{1280, 800};
    std::pair<double, double> camera{View{}.azimuth, View{}.elevation};  ///< degrees
    std::optional<std::pair<double, double>> slice_camera;
    double fov = View{}.fov;
    int slices = 0;
    int samples = 4;
};

void add_options(CLI::App& app, ViewOptions& options);

View view_of(const ViewOptions& options);

/// The view whose slices are drawn, if not the picture's own.
std::optional<View> slice_view_of(const ViewOptions& options);

}  // namespace vvr
