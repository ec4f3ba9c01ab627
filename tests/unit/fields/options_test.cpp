#include "core/fields/options.h"

#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/fields/seeds.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

std::string error_of(const std::function<void(fields::FieldOptions&)>& change) {
    return test::error_text(ErrorKind::usage, [&] {
        fields::FieldOptions options;
        change(options);
        fields::validate(options);
    });
}

TEST(FieldOptions, DefaultsAreValid) {
    EXPECT_EQ(error_of([](fields::FieldOptions&) {}), "no error");
}

TEST(FieldOptions, NumbersOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_of([](auto& o) { o.threshold = 256; }), "threshold: 256 is not between 0 and 255");
    EXPECT_EQ(error_of([](auto& o) { o.min_area = -1; }), "min-area: -1 is not between 0 and 1000000");
    EXPECT_EQ(error_of([&](auto& o) { o.smooth = nan; }), "smooth: nan is not between 0 and 20");
    EXPECT_EQ(error_of([&](auto& o) { o.flow.alpha = nan; }), "alpha: nan is not between 0.01 and 10000");
    EXPECT_EQ(error_of([&](auto& o) { o.flow.alpha = infinity; }), "alpha: inf is not between 0.01 and 10000");
    EXPECT_EQ(error_of([](auto& o) { o.flow.alpha = 0; }), "alpha: 0 is not between 0.01 and 10000");
    EXPECT_EQ(error_of([](auto& o) { o.flow.iterations = 0; }), "iterations: 0 is not between 1 and 100000");
    EXPECT_EQ(error_of([](auto& o) { o.seeds.grid = 0; }), "grid: 0 is not between 1 and 10000");
    EXPECT_EQ(error_of([&](auto& o) { o.seeds.min_magnitude = -infinity; }),
              "min-magnitude: -inf is not between 0 and 10000");
    EXPECT_NE(error_of([](auto& o) { o.span.start = -1; }).find("start: -1"), std::string::npos);
    EXPECT_EQ(error_of([](auto& o) { o.span.start = 2, o.span.end = 1; }),
              "end: the clip from 2 s to 1 s is empty; give an end after the start");
    EXPECT_NE(error_of([](auto& o) { o.flow.every = 0; }).find("flow-every: 0"), std::string::npos);
}

TEST(FieldOptions, UnknownNames) {
    EXPECT_TRUE(
        error_of([](auto& o) { o.filter = "diference"; })
            .starts_with("filter: 'diference' is unknown (did you mean 'difference'?); choose one of: difference, "
                         "temporal, hull, "));
    EXPECT_EQ(error_of([](auto& o) { o.reference = "medain"; }),
              "reference: 'medain' is unknown (did you mean 'median'?); choose one of: median, first, running, or the "
              "name of a picture");
    EXPECT_EQ(error_of([](auto& o) { o.illumination = "globl"; }),
              "illumination: 'globl' is unknown (did you mean 'global'?); choose one of: global, local, none");
    EXPECT_EQ(error_of([](auto& o) { o.seeds.order = "size"; }),
              "seed-order: 'size' is unknown; choose one of: magnitude, difference, age");
    EXPECT_EQ(error_of([](auto& o) { o.flow.solver = "pyramids"; }),
              "solver: 'pyramids' is unknown (did you mean 'pyramid'?); choose one of: pyramid, jacobi");
}

TEST(FieldOptions, SeedSelections) {
    for (const char* const good : {"all", "first:1", "first:0", "random:20", "random:20:7"}) {
        EXPECT_EQ(error_of([&](auto& o) { o.seeds.select = fields::parse_seed_selection(good); }), "no error") << good;
    }
    for (const char* const bad :
         {"", "All", "first", "first:", "first:-1", "first:1x", "random:", "random:1:", "random:1:x"}) {
        EXPECT_EQ(error_of([&](auto& o) { o.seeds.select = fields::parse_seed_selection(bad); }),
                  std::string("seed-select: '") + bad + "' is not one of: all, first:N, random:N, random:N:NUMBER");
    }
}

TEST(FieldOptions, Polygons) {
    for (const char* const good : {"", "0,0 10,0 10,10", "-5,-5 1e3,0.5 20,90 ; 1,1 2,2 3,1", "mask.png"}) {
        EXPECT_EQ(error_of([&](auto& o) { o.roi = good; }), "no error") << good;
    }
    const auto polygon_error = [](const char* text) { return error_of([&](auto& o) { o.mask = text; }); };
    EXPECT_NE(
        polygon_error("0,0 10,0").find("mask: a polygon needs at least three points at character 9 of \"0,0 10,0\""),
        std::string::npos);
    EXPECT_NE(polygon_error("0,0 10,0 5,5;").find("at least three points"), std::string::npos);
    EXPECT_NE(polygon_error("0,0 10,0 5;5").find("expected ',' and the point's y at character 11"), std::string::npos);
    EXPECT_NE(polygon_error("0,0 10,0 x,5").find("expected a number at character 10"), std::string::npos);
    EXPECT_NE(polygon_error("0,nan 10,0 5,5").find("a coordinate must be from -100000 to 100000"), std::string::npos);
    EXPECT_NE(polygon_error("0,0 inf,0 5,5").find("a coordinate must be from"), std::string::npos);
    EXPECT_NE(polygon_error("0,0 1e9,0 5,5").find("a coordinate must be from"), std::string::npos);
}

}  // namespace
}  // namespace vvr
