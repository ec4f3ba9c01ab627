#include "core/scene/transfer_function.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"

namespace vvr::scene {

TransferFunction::TransferFunction(std::vector<TransferPoint> points) : points_(std::move(points)) {
    if (points_.empty()) throw Error(ErrorCode::option_value, "a transfer function has no points; give at least one");
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const TransferPoint& point = points_[i];
        if (!(point.extinction >= 0) || !std::isfinite(point.extinction) || !std::isfinite(point.value)) {
            throw Error(
                ErrorCode::option_value_out_of_range,
                fmt::format("point {} of the transfer function has the value {} and the extinction {}; give finite "
                            "numbers, and an extinction of at least 0",
                            i + 1, point.value, point.extinction));
        }
        if (i > 0 && point.value < points_[i - 1].value) {
            throw Error(ErrorCode::option_value,
                        fmt::format("the values of a transfer function must increase, but {} follows {}", point.value,
                                    points_[i - 1].value));
        }
    }
    // A value is visible if the extinction is above zero at the value or before the next one.
    for (int i = 0; i < 256; ++i) {
        const bool here = at(i).w > 0;
        visible_below_[static_cast<std::size_t>(i) + 1] = visible_below_[static_cast<std::size_t>(i)] + (here ? 1 : 0);
    }
}

glm::dvec4 TransferFunction::at(double value) const {
    const auto after = std::ranges::upper_bound(points_, value, {}, &TransferPoint::value);
    if (after == points_.begin()) return {points_.front().colour, points_.front().extinction};
    if (after == points_.end()) return {points_.back().colour, points_.back().extinction};
    const TransferPoint& low = *(after - 1);
    const double share = (value - low.value) / (after->value - low.value);
    return {glm::mix(low.colour, after->colour, share), std::lerp(low.extinction, after->extinction, share)};
}

bool TransferFunction::visible(const volume::ValueRange& range) const {
    if (range.high < range.low) return false;
    return visible_below_[static_cast<std::size_t>(range.high) + 1] > visible_below_[range.low];
}

TransferFunction TransferFunction::scaled(double opacity) const {
    std::vector<TransferPoint> points = points_;
    for (TransferPoint& point : points) point.extinction *= opacity;
    return TransferFunction(std::move(points));
}

TransferFunction default_transfer_function() {
    return TransferFunction({
        {12, {0.20, 0.38, 0.62}, 0},
        {48, {0.22, 0.45, 0.70}, 9},
        {128, {0.16, 0.30, 0.58}, 32},
        {255, {0.08, 0.14, 0.36}, 70},
    });
}

namespace {

struct Column {
    std::string_view name;
    double high;
};
constexpr std::array columns{Column{"value", 255}, Column{"red", 1}, Column{"green", 1}, Column{"blue", 1},
                             Column{"opacity", 1}};

constexpr std::string_view blanks = " \t\r,";

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    line = line.substr(0, line.find('#'));
    for (auto begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = line.find_first_not_of(blanks)) {
        line.remove_prefix(begin);
        words.push_back(line.substr(0, line.find_first_of(blanks)));
        line.remove_prefix(words.back().size());
    }
    return words;
}

double number_in(std::string_view word, const Column& column, const std::string& where) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size() && value >= 0 && value <= column.high) return value;
    throw Error(ErrorCode::option_value,
                fmt::format("{}: {} is '{}'; give a number from 0 to {}", where, column.name, word, column.high));
}

std::string read_text(const std::filesystem::path& path) {
    try {
        return read_file(path.string(), most_bytes::text);
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("transfer: {}", error.what()), {"transfer"});
    }
}

}  // namespace

const std::vector<TransferRow>& transfer_functions() {
    static const std::vector<TransferRow> table = {
        {"blue", "motion in blue, from faint to strong", default_transfer_function().points()},
        {"grey",
         "the same in grey, for print",
         {{12, {0.62, 0.62, 0.62}, 0},
          {48, {0.55, 0.55, 0.55}, 9},
          {128, {0.33, 0.33, 0.33}, 32},
          {255, {0.08, 0.08, 0.08}, 70}}},
        {"heat",
         "from yellow through red to black: the colour shows the size of a difference",
         {{12, {1.00, 0.86, 0.45}, 0},
          {40, {0.98, 0.72, 0.25}, 7},
          {90, {0.92, 0.35, 0.14}, 24},
          {160, {0.66, 0.08, 0.16}, 44},
          {255, {0.22, 0.02, 0.12}, 70}}},
        {"viridis",
         "from violet through green to yellow: readable with colour blindness, and in grey",
         {{12, {0.27, 0.00, 0.33}, 0},
          {48, {0.23, 0.32, 0.55}, 9},
          {110, {0.13, 0.57, 0.55}, 28},
          {180, {0.37, 0.79, 0.38}, 48},
          {255, {0.99, 0.91, 0.14}, 70}}},
        {"magma",
         "from black through purple to pale yellow, likewise",
         {{12, {0.05, 0.03, 0.12}, 0},
          {48, {0.32, 0.07, 0.49}, 9},
          {110, {0.72, 0.21, 0.48}, 28},
          {180, {0.99, 0.54, 0.38}, 48},
          {255, {0.99, 0.99, 0.75}, 70}}},
        {"coolwarm",
         "from blue through grey to red: separates weak from strong differences",
         {{12, {0.23, 0.30, 0.75}, 0},
          {48, {0.38, 0.50, 0.90}, 9},
          {128, {0.86, 0.86, 0.86}, 30},
          {190, {0.88, 0.45, 0.36}, 50},
          {255, {0.71, 0.02, 0.15}, 70}}},
        {"mist",
         "thin everywhere, for crowds: objects behind others stay visible",
         {{12, {0.30, 0.45, 0.60}, 0}, {64, {0.24, 0.40, 0.58}, 2}, {255, {0.10, 0.20, 0.42}, 9}}},
        {"solid",
         "opaque from a low value on: shows shapes, not strengths",
         {{20, {0.34, 0.52, 0.70}, 0}, {28, {0.30, 0.48, 0.68}, 160}, {255, {0.12, 0.22, 0.45}, 220}}},
        {"bands",
         "for the filter bands: background clear, uncovered blue, still covered grey, newly covered red",
         {{84, {0.10, 0.45, 0.85}, 0},
          {85, {0.10, 0.45, 0.85}, 70},
          {86, {0.10, 0.45, 0.85}, 0},
          {169, {0.45, 0.45, 0.45}, 0},
          {170, {0.45, 0.45, 0.45}, 22},
          {171, {0.45, 0.45, 0.45}, 0},
          {254, {0.86, 0.20, 0.12}, 0},
          {255, {0.86, 0.20, 0.12}, 120}}},
        {"signed",
         "for the filter signed: darker than the empty scene in blue, brighter in red",
         {{0, {0.04, 0.12, 0.52}, 0},
          {1, {0.04, 0.12, 0.52}, 70},
          {80, {0.16, 0.40, 0.80}, 32},
          {122, {0.45, 0.66, 0.92}, 6},
          {128, {0.80, 0.80, 0.80}, 0},
          {134, {0.96, 0.62, 0.45}, 6},
          {176, {0.88, 0.30, 0.14}, 32},
          {255, {0.55, 0.03, 0.10}, 70}}},
    };
    return table;
}

double extinction_of(double opacity) {
    return -std::log1p(-std::min(opacity, 0.999)) / opacity_unit_distance;
}

TransferFunction parse_transfer(const std::string& text, const std::string& name) {
    std::vector<TransferPoint> points;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::string where = fmt::format("{}:{}", name, ++number);
        const auto words = words_of(line);
        if (words.empty()) continue;
        if (words.size() != columns.size()) {
            throw Error(ErrorCode::option_value,
                        fmt::format("{}: found {} numbers; give {}: value red green blue opacity", where, words.size(),
                                    columns.size()));
        }
        std::array<double, columns.size()> values{};
        for (std::size_t i = 0; i < columns.size(); ++i) values[i] = number_in(words[i], columns[i], where);
        if (!points.empty() && values[0] <= points.back().value) {
            throw Error(ErrorCode::option_value, fmt::format("{}: value {} follows {}; values must increase", where,
                                                             values[0], points.back().value));
        }
        points.push_back({values[0], {values[1], values[2], values[3]}, extinction_of(values[4])});
    }
    if (points.empty()) {
        throw Error(
            ErrorCode::option_value,
            fmt::format("{}: found no points; give at least one line with: value red green blue opacity", name));
    }
    return TransferFunction(std::move(points));
}

TransferFunction find_transfer(const std::string& name_or_file) {
    std::error_code none;
    const bool named = std::ranges::count(transfer_functions(), name_or_file, &TransferRow::name) > 0;
    if (!named && std::filesystem::exists(name_or_file, none)) {
        return parse_transfer(read_text(name_or_file), name_or_file);
    }
    return TransferFunction(choose("transfer", name_or_file, transfer_functions(), ", or the name of a file").points);
}

}  // namespace vvr::scene
