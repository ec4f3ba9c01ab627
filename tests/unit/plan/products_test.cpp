// What a run makes, and what it keeps of the fields for that.
#include <array>
#include <functional>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "cli/plan/make_plan.h"
#include "tests/unit/plan/header.h"

namespace vvr {
namespace {

using app::Purpose;

/// What is made and kept.
struct Products {
    int pictures = 1;
    bool pixel_data = false;
    bool lists_events = false;
    bool keeps_portraits = true;
    bool keeps_moments = false;
    bool keeps_boxes = false;
    bool finds_objects = true;
};

struct ProductsCase {
    const char* name;
    std::function<void(app::RenderJob&)> ask;
    Products made;
    Purpose purpose = Purpose::files;
};

std::ostream& operator<<(std::ostream& out, const ProductsCase& row) {
    return out << row.name;
}

class ProductsOfAPlan : public testing::TestWithParam<ProductsCase> {};

TEST_P(ProductsOfAPlan, AreWhatIsAskedFor) {
    app::RenderJob job;
    GetParam().ask(job);
    const app::Plan plan = app::make_plan(job, test::header_of(), GetParam().purpose);
    const Products made{plan.output.pictures,       plan.look.pixel_data,     plan.field.lists_events,
                        plan.field.keeps_portraits, plan.field.keeps_moments, plan.field.keeps_boxes,
                        plan.field.finds_objects};
    const Products& wanted = GetParam().made;
    EXPECT_EQ(made.pictures, wanted.pictures);
    EXPECT_EQ(made.pixel_data, wanted.pixel_data) << "pixel data";
    EXPECT_EQ(made.lists_events, wanted.lists_events) << "events";
    EXPECT_EQ(made.keeps_portraits, wanted.keeps_portraits) << "portraits";
    EXPECT_EQ(made.keeps_moments, wanted.keeps_moments) << "moments";
    EXPECT_EQ(made.keeps_boxes, wanted.keeps_boxes) << "boxes";
    EXPECT_EQ(made.finds_objects, wanted.finds_objects) << "objects";
}

void only_volume(app::RenderJob& job) {
    job.look.show = {app::Part::volume};
}

INSTANTIATE_TEST_SUITE_P(
    Plans, ProductsOfAPlan,
    testing::Values(
        ProductsCase{"a picture", [](auto& job) { job.output.path = "a.png"; }, {}},
        ProductsCase{"of the volume alone",
                     [](auto& job) { job.output.path = "a.png", only_volume(job); },
                     {.keeps_portraits = false, .finds_objects = false}},
        ProductsCase{"an EXR", [](auto& job) { job.output.path = "a.exr"; }, {.pixel_data = true}},
        ProductsCase{"standard output", [](auto& job) { job.output.path = "-"; }, {}},
        ProductsCase{"a film", [](auto& job) { job.output.path = "a.mp4"; }, {.pictures = app::default_animation}},
        ProductsCase{"a film of the window",
                     [](auto& job) { job.output.path = "a.mp4", job.output.slide = 5; },
                     {.pictures = 5}},
        ProductsCase{"a page",
                     [](auto& job) { job.output.path = "a.html", only_volume(job); },
                     {.pixel_data = true, .lists_events = true, .keeps_moments = true}},
        ProductsCase{"a page of what marks no objects",
                     [](auto& job) { job.output.path = "a.html", job.fields.filter = "edges"; },
                     {.pixel_data = true, .keeps_portraits = false, .keeps_moments = true, .finds_objects = false}},
        ProductsCase{"a still",
                     [](auto& job) { job.output.path = "a.png", job.output.still = "s.png"; },
                     {.keeps_moments = true}},
        ProductsCase{"a report alone",
                     [](auto& job) { job.output.report = "r.json", only_volume(job); },
                     {.pictures = 0, .lists_events = true, .keeps_portraits = false}},
        ProductsCase{"a table",
                     [](auto& job) { job.output.path = "a.png", job.output.events_csv = "e.csv"; },
                     {.lists_events = true}},
        ProductsCase{"boxes",
                     [](auto& job) { job.output.path = "a.png", job.output.tracks = "t.txt"; },
                     {.lists_events = true, .keeps_boxes = true}},
        ProductsCase{"a golden picture", [](auto& job) { job.output.golden.path = "g.png"; }, {}},
        ProductsCase{"a search", [](auto&) {}, {.pictures = 0, .lists_events = true}, Purpose::search},
        ProductsCase{"of a caller",
                     [](auto& job) { job.output.returns_pixel_data = true; },
                     {.pixel_data = true},
                     Purpose::caller},
        ProductsCase{"a stream",
                     [](auto& job) { job.output.path = "a.png", only_volume(job); },
                     {.keeps_portraits = false, .keeps_moments = true, .finds_objects = false},
                     Purpose::stream},
        ProductsCase{"a stream whose events are reported",
                     [](auto& job) { job.output.path = "a.png", only_volume(job), job.output.reports_events = true; },
                     {.keeps_portraits = false, .keeps_moments = true},
                     Purpose::stream},
        ProductsCase{"a stream with a page",
                     [](auto& job) { job.output.path = "a.html", only_volume(job); },
                     {.pixel_data = true, .keeps_moments = true, .finds_objects = false},
                     Purpose::stream}));

TEST(NeedsOfAPlan, FollowFromTheParts) {
    app::RenderJob job;
    const auto field = [&] { return app::make_plan(job, test::header_of()).field; };
    EXPECT_FALSE(field().flow || field().seeds || field().keeps_frames);
    job.look.keyframes = 2;
    EXPECT_TRUE(field().keeps_frames);
    job.look.show.add(app::Part::arrows);
    EXPECT_TRUE(field().seeds && !field().flow);
    job.look.show.add(app::Part::tracelines);
    EXPECT_TRUE(field().seeds && field().flow);
}

TEST(PageOfAPlan, KnowsWhereItIsInTheEnd) {
    app::RenderJob job;
    job.input.names = {"in/gate.avi"};
    job.output.path = "tmp/a.png";
    EXPECT_TRUE(app::make_plan(job, test::header_of()).page.path.empty()) << "there is no page";
    job.output.page = "tmp/a.html";
    EXPECT_EQ(app::make_plan(job, test::header_of()).page.path, "tmp/a.html");
    job.output.page_place = "out/a.html";
    job.output.pieces.place = "out/a";
    job.output.page_camera = "Gate";
    job.output.page_heading = "Hall";
    app::PagePlan page = app::make_plan(job, test::header_of()).page;
    EXPECT_EQ(page.path, "out/a.html");
    EXPECT_EQ(page.pieces, "out/a");
    EXPECT_EQ(page.camera, "Gate");
    EXPECT_EQ(page.heading, "Hall");
    EXPECT_EQ(page.file, "gate.avi");
    EXPECT_FALSE(page.is_titled);
    EXPECT_FALSE(page.plays_file) << "there is no such file";
    EXPECT_EQ(page.file_ending, "");
    job.look.title = "the gate";
    job.input.names.emplace_back("in/hall.avi");
    page = app::make_plan(job, test::header_of()).page;
    EXPECT_TRUE(page.is_titled);
    EXPECT_EQ(page.file, "2 files");
}

}  // namespace
}  // namespace vvr
