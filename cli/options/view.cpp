#include "cli/options/view.h"

#include <fmt/format.h>

#include "cli/options/option.h"

namespace vvr {

namespace {

std::pair<double, double> parse_radii(const std::string& text) {
    constexpr Range range{0.01, 100};
    const auto radii = parse_pair(text, ':', range, range);
    if (radii.first >= radii.second) {
        throw Error(ErrorKind::usage, fmt::format("'{}': the outer radius has to be larger than the inner one", text));
    }
    return radii;
}

std::pair<double, double> parse_camera(const std::string& text) {
    return parse_pair(text, ',', {-360, 360}, {-90, 90});
}

std::string join(const std::pair<double, double>& pair, char separator) {
    return fmt::format("{}{}{}", pair.first, separator, pair.second);
}

}  // namespace

void add_options(CLI::App& app, ViewOptions& options) {
    add_choice(app, group::view, options.layout, layouts(), {"--layout", "NAME", "", "how the volume stands"});
    add_option(app, group::view, options.radii,
               {"--radius", "IN:OUT", join(options.radii, ':'), "radii of the horseshoe"}, parse_radii);
    add_option(app, group::view, options.height,
               {"--height", "UNITS", "", "height of a frame, 0.001..100; square pixels if not given"},
               [](const std::string& given) {
                   return parse_number(given, {0.001, 100});
               });
    add_option(app, group::view, options.size,
               {"--size", "WxH", fmt::format("{}x{}", options.size.width, options.size.height),
                "pixels of the picture, each side 1..16384"},
               parse_size);
    add_option(app, group::view, options.camera,
               {"--camera", "AZIMUTH,ELEVATION", join(options.camera, ','),
                "where the viewer stands, degrees to the right and above the floor"},
               parse_camera);
    add_option(app, group::view, options.slice_camera,
               {"--slice-view", "AZIMUTH,ELEVATION", "",
                "whose slices --show slices draws; those of the picture's own camera if not given"},
               parse_camera);
    add_number(app, group::view, options.fov, {0, 150},
               {"--fov", "DEGREES", "", "vertical field of view; 0 = orthographic"});
    add_integer(app, group::view, options.slices, 0, 16384,
                {"--slices", "COUNT", "auto", "slices of the volume; 0 = one for every two voxels"});
    add_integer(app, group::view, options.samples, 1, 64,
                {"--samples", "COUNT", "", "samples a pixel, for smooth edges, as far as OpenGL has so many"});
}

View view_of(const ViewOptions& options) {
    View view;
    view.azimuth = options.camera.first;
    view.elevation = options.camera.second;
    view.fov = options.fov;
    return view;
}

std::optional<View> slice_view_of(const ViewOptions& options) {
    if (!options.slice_camera) return std::nullopt;
    View view = view_of(options);
    view.azimuth = options.slice_camera->first;
    view.elevation = options.slice_camera->second;
    return view;
}

}  // namespace vvr
