#include "core/fields/region.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fields/settings.h"
#include "core/footage/open_source.h"
#include "core/media/frame_source.h"
#include "core/media/scaler.h"

namespace vvr::fields {
namespace {

using Polygon = std::vector<cv::Point2d>;

// Beyond any picture, but safe in the rasterizer's fixed-point arithmetic.
constexpr double farthest = 100000;

class Parser {
  public:
    Parser(std::string_view setting, std::string_view text) : setting_(setting), text_(text) {}

    std::vector<Polygon> polygons() {
        std::vector<Polygon> result(1);
        while (true) {
            skip_spaces();
            if (at_ == text_.size() || text_[at_] == ';') {
                if (result.back().size() < 3) fail("a polygon needs at least three points");
                if (at_ == text_.size()) return result;
                ++at_;
                result.emplace_back();
                continue;
            }
            const double x = number();
            if (at_ == text_.size() || text_[at_] != ',') fail("expected ',' and the point's y");
            ++at_;
            const double y = number();
            result.back().push_back({x, y});
        }
    }

  private:
    void skip_spaces() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }

    double number() {
        double value = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc()) fail("expected a number");
        if (!(std::abs(value) <= farthest)) fail(fmt::format("a coordinate must be from -{0} to {0}", farthest));
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(
            ErrorCode::option_value,
            fmt::format("{}: {} at character {} of \"{}\"; give points \"x,y x,y x,y\" in pixels of the video, "
                        "with ';' between polygons, or the name of a picture or of a text file (.txt) of polygons",
                        setting_, what, at_ + 1, text_),
            {setting_});
    }

    std::string_view setting_;
    std::string_view text_;
    std::size_t at_ = 0;
};

void draw(Plane<std::uint8_t>& plane, const std::vector<Polygon>& polygons, Size video) {
    // Units of 1/16 pixel. OpenCV's integer coordinates are pixel centres, ours are corners.
    constexpr int shift = 4;
    const double scale_x = static_cast<double>(plane.width()) / video.width;
    const double scale_y = static_cast<double>(plane.height()) / video.height;
    for (const Polygon& polygon : polygons) {
        std::vector<cv::Point> points;
        for (const cv::Point2d& p : polygon) {
            points.emplace_back(static_cast<int>(std::lround((p.x * scale_x - 0.5) * (1 << shift))),
                                static_cast<int>(std::lround((p.y * scale_y - 0.5) * (1 << shift))));
        }
        cv::Mat out = cv_view(plane);
        cv::fillPoly(out, std::vector{points}, 255, cv::LINE_8, shift);
    }
}

bool is_polygon_file(std::string_view text) {
    return extension_of(text) == ".txt";
}

/// The lines of a text file as one list.
/// \throws Error io
std::string read_polygons(const std::string& file) {
    std::istringstream lines(read_file(file, most_bytes::text));
    std::string list;
    for (std::string line; std::getline(lines, line);) {
        line.resize(std::min(line.find('#'), line.size()));
        std::ranges::replace_if(
            line, [](unsigned char c) { return std::isspace(c) != 0; }, ' ');
        if (line.find_first_not_of(' ') == std::string::npos) continue;
        list += (list.empty() ? "" : ";") + line;
    }
    return list;
}

std::string read_polygons(std::string_view setting, const std::string& file) {
    try {
        return read_polygons(file);
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("{}: {}", setting, error.what()), {setting});
    }
}

std::vector<Polygon> polygons_of(std::string_view setting, const std::string& text) {
    if (!is_polygon_file(text)) return Parser(setting, text).polygons();
    const std::string list = read_polygons(setting, text);
    try {
        return Parser(setting, list).polygons();
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("{}; this text is in the file '{}'", error.what(), text), error.about());
    }
}

Plane<std::uint8_t> area(std::string_view setting, const std::string& text, Size field, Size video) {
    if (is_polygon_list(text) || is_polygon_file(text)) {
        Plane<std::uint8_t> plane(field);
        draw(plane, polygons_of(setting, text), video);
        if (setting == setting::roi.name && std::ranges::all_of(plane.pixels(), [](auto p) { return p == 0; })) {
            throw Error(
                ErrorCode::option_value_out_of_range,
                fmt::format("{}: \"{}\" lies outside the frame of {}x{} pixels; give pixels of the video, from its top "
                            "left corner",
                            setting, text, video.width, video.height),
                {setting});
        }
        return plane;
    }
    check_is_file(text);
    media::SourceOptions options;
    options.field_size = field;
    const auto picture = footage::open_source(text, options);
    Plane<std::uint8_t> plane = media::Scaler(*picture)(*picture->next()).grey;
    for (std::uint8_t& p : plane.pixels()) p = p >= 128 ? 255 : 0;
    return plane;
}

}  // namespace

bool is_polygon_list(std::string_view text) {
    // A text that begins with a number and a comma is meant as a polygon, not as a file's name.
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return false;
    double x = 0;
    const std::size_t begin = text.find_first_not_of(' ');
    const char* const end = text.data() + comma;
    return begin < comma && std::from_chars(text.data() + begin, end, x).ptr == end;
}

std::string polygon_list(std::string_view setting, const std::string& text) {
    validate_region(setting, text);
    if (is_polygon_list(text)) return text;
    return is_polygon_file(text) ? read_polygons(setting, text) : std::string();
}

void validate_region(std::string_view setting, const std::string& text) {
    if (is_polygon_list(text) || is_polygon_file(text)) polygons_of(setting, text);
}

bool has_region(const FieldOptions& options) {
    return !options.roi.empty() || !options.mask.empty();
}

Plane<std::uint8_t> make_region(const FieldOptions& options, Size field, Size video) {
    if (!has_region(options) && options.overlays.empty()) return {};
    Plane<std::uint8_t> region =
        options.roi.empty() ? Plane<std::uint8_t>(field, 255) : area(setting::roi.name, options.roi, field, video);
    if (!options.mask.empty()) {
        const Plane<std::uint8_t> mask = area(setting::mask.name, options.mask, field, video);
        for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
            if (mask.pixels()[i] != 0) region.pixels()[i] = 0;
        }
    }
    for (const PixelBox& overlay : options.overlays) fill(region, overlay, 0);
    return region;
}

}  // namespace vvr::fields
