#include <tuple>

#include "cli/app/settings.h"
#include "cli/options/job_options.h"
#include "cli/options/parse_value.h"

namespace vvr::options {

namespace {

void set_direction(space::View& view, const std::string& text) {
    std::tie(view.azimuth, view.elevation) = parse_pair(text, ',', {-360, 360}, {-90, 90});
}

}  // namespace

void add_view_options(CommandLine& line, app::RenderJob& job) {
    constexpr Group view = Group::view;
    gl::RenderOptions& picture = job.picture;
    line.choice(view, space::layouts(), job.layout, setting::layout);
    line.value(view, setting::radius, fmt::format("{}:{}", job.shape.r_min, job.shape.r_max),
               [&shape = job.shape](const std::string& given) {
                   std::tie(shape.r_min, shape.r_max) =
                       parse_pair(given, ':', setting::radius.range, setting::radius.range);
                   app::validate(shape);
               });
    line.value(view, setting::height, "", [&shape = job.shape](const std::string& given) {
        shape.height = parse_number(given, setting::height.range);
    });
    line.value(view, setting::size, fmt::format("{}x{}", picture.size.width, picture.size.height),
               [&picture](const std::string& given) { picture.size = parse_size(given); });
    line.value(view, setting::camera, fmt::format("{},{}", picture.view.azimuth, picture.view.elevation),
               [&picture](const std::string& given) { set_direction(picture.view, given); });
    line.value(view, setting::slice_view, "", [&look = job.look](const std::string& given) {
        look.slice_view.emplace();
        set_direction(*look.slice_view, given);
    });
    line.number(view, picture.view.fov, setting::fov);
    line.value(view, setting::slices, std::string(setting::slices.default_text), [&picture](const std::string& given) {
        const auto [low, high] = setting::slices.range;
        picture.slices = given == "auto" ? 0
                                         : static_cast<int>(parse_integer(given, static_cast<std::int64_t>(low),
                                                                          static_cast<std::int64_t>(high)));
    });
    line.number(view, picture.samples, setting::samples);
}

}  // namespace vvr::options
