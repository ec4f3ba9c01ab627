#include "core/fields/options.h"

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/seeds.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

using Edit = std::function<void(fields::FieldOptions&)>;

void validate(const Edit& change) {
    fields::FieldOptions options;
    change(options);
    fields::validate(options);
}

TEST(FieldOptions, NumbersOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<std::pair<std::string, Edit>> wrong{
        {"threshold: 256", [](auto& o) { o.threshold = 256; }},
        {"min-area: -1", [](auto& o) { o.min_area = -1; }},
        {"smooth: nan", [&](auto& o) { o.smooth = nan; }},
        {"alpha: inf", [&](auto& o) { o.flow.alpha = infinity; }},
        {"alpha: 0 ", [](auto& o) { o.flow.alpha = 0; }},
        {"iterations: 0 ", [](auto& o) { o.flow.iterations = 0; }},
        {"grid: 0 ", [](auto& o) { o.seeds.grid = 0; }},
        {"min-magnitude: -inf", [&](auto& o) { o.seeds.min_magnitude = -infinity; }},
        {"flow-every: 0 ", [](auto& o) { o.flow.every = 0; }},
        {"start: -1", [](auto& o) { o.span.start = -1; }}};
    for (const auto& [fact, change] : wrong) {
        test::expect_error(ErrorCode::option_value_out_of_range, [&change = change] { validate(change); }, {fact});
    }
    test::expect_error(ErrorCode::span_empty, [] { validate([](auto& o) { o.span.start = 2, o.span.end = 1; }); });
    EXPECT_NO_THROW(validate([](auto&) {})) << "the defaults";
}

TEST(FieldOptions, SeedSelections) {
    for (const char* const good : {"all", "first:1", "first:0", "random:20", "random:20:7"}) {
        EXPECT_NO_THROW(fields::parse_seed_selection(good)) << good;
    }
    for (const char* const bad :
         {"", "All", "first", "first:", "first:-1", "first:1x", "random:", "random:1:", "random:1:x"}) {
        test::expect_error(ErrorCode::option_value, [&] { fields::parse_seed_selection(bad); }, {bad});
    }
}

TEST(FieldOptions, Polygons) {
    for (const char* const good : {"", "0,0 10,0 10,10", "-5,-5 1e3,0.5 20,90 ; 1,1 2,2 3,1", "mask.png"}) {
        EXPECT_NO_THROW(validate([&](auto& o) { o.roi = good; })) << good;
    }
    for (const auto& [bad, place] : std::vector<std::pair<std::string, std::string>>{{"0,0 10,0", "character 9 "},
                                                                                     {"0,0 10,0 5,5;", "character 14 "},
                                                                                     {"0,0 10,0 5;5", "character 11 "},
                                                                                     {"0,0 10,0 x,5", "character 10 "},
                                                                                     {"0,nan 10,0 5,5", "100000"},
                                                                                     {"0,0 inf,0 5,5", "100000"},
                                                                                     {"0,0 1e9,0 5,5", "100000"}}) {
        test::expect_error(ErrorCode::option_value, [&, text = bad] { validate([&](auto& o) { o.mask = text; }); },
                           {"mask", place});
    }
}

}  // namespace
}  // namespace vvr
