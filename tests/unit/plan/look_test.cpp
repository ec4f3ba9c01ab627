// How the volume of a plan is coloured, and what is shown of it.
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "cli/plan/make_plan.h"
#include "core/fields/filter.h"
#include "core/image/picture.h"
#include "core/scene/transfer_function.h"
#include "tests/support/errors.h"
#include "tests/unit/plan/header.h"

namespace vvr {
namespace {

using app::Part;

struct ColourCase {
    const char* name;
    const char* filter = "difference";
    const char* asked = "auto";
    std::optional<app::Parts> show{};
    const char* transfer = "";  ///< empty = none is asked for
    const char* theme = "light";
    const char* colour = "";    ///< that is chosen
    const char* recorded = "";  ///< the transfer function in the record, unless it was asked for
    bool finds_objects = true;
};

std::ostream& operator<<(std::ostream& out, const ColourCase& row) {
    return out << row.name;
}

app::RenderJob job_of(const ColourCase& row) {
    app::RenderJob job;
    job.fields.filter = row.filter;
    job.look.colour = row.asked;
    if (row.show) job.look.show = *row.show;
    if (*row.transfer) job.look.transfer = app::NamedTransfer{row.transfer, scene::find_transfer(row.transfer)};
    for (const scene::Theme& theme : scene::themes()) {
        if (theme.name == row.theme) job.look.theme = theme;
    }
    return job;
}

class ColourOfAPlan : public testing::TestWithParam<ColourCase> {};

TEST_P(ColourOfAPlan, FollowsFromFilterAndParts) {
    const ColourCase& row = GetParam();
    const app::Plan plan = app::make_plan(job_of(row), test::header_of());
    EXPECT_EQ(plan.volume.colour->name, row.colour);
    EXPECT_EQ(image::value_of(plan.output.settings, "color"), row.colour);
    EXPECT_EQ(image::value_of(plan.output.settings, "transfer"), row.recorded);
    EXPECT_EQ(plan.look.picture.colour, plan.volume.colour->drawn);
    EXPECT_EQ(plan.field.finds_objects, row.finds_objects);
}

INSTANTIATE_TEST_SUITE_P(
    Plans, ColourOfAPlan,
    testing::Values(ColourCase{.name = "objects", .colour = "object", .recorded = "blue"},
                    ColourCase{.name = "a theme's transfer", .theme = "print", .colour = "object", .recorded = "grey"},
                    ColourCase{.name = "a transfer function is for values", .transfer = "heat", .colour = "transfer"},
                    ColourCase{.name = "objects though a transfer function is given",
                               .asked = "object",
                               .transfer = "heat",
                               .colour = "object"},
                    ColourCase{.name = "no part describes objects",
                               .show = app::Parts{Part::volume, Part::ruler},
                               .colour = "transfer",
                               .recorded = "blue",
                               .finds_objects = false},
                    ColourCase{
                        .name = "no volume", .show = app::Parts{Part::map}, .colour = "transfer", .recorded = "blue"},
                    ColourCase{.name = "a filter that marks none",
                               .filter = "edges",
                               .colour = "transfer",
                               .recorded = "blue",
                               .finds_objects = false},
                    ColourCase{.name = "a filter's own transfer",
                               .filter = "bands",
                               .show = app::Parts{Part::volume},
                               .colour = "transfer",
                               .recorded = "bands",
                               .finds_objects = false},
                    ColourCase{.name = "time", .asked = "time", .colour = "time", .recorded = "blue"},
                    ColourCase{.name = "a second filter", .asked = "edges", .colour = "edges"}));

TEST(ColourOfAPlan, ThatNeedsWhatIsNotThereIsRefused) {
    const auto refuses = [](const app::RenderJob& job, std::initializer_list<std::string_view> facts) {
        test::expect_error(
            ErrorCode::options_conflict, [&] { app::make_plan(job, test::header_of()); }, facts);
    };
    refuses(job_of({.name = "", .filter = "edges", .asked = "object"}), {"object", "'edges'"});
    for (const char* const colour : {"direction", "speed", "flow"}) {
        app::RenderJob job = job_of({.name = "", .asked = colour});
        EXPECT_NO_THROW(app::make_plan(job, test::header_of())) << colour;
        job.fields.flow.method = fields::FlowChoice::none();
        refuses(job, {colour, "none"});
    }
}

TEST(PartsOfAPlan, AreThoseThatTheFilterAllows) {
    const auto shown = [](const app::RenderJob& job) { return app::make_plan(job, test::header_of()).look; };
    app::RenderJob job;
    for (const Part part : {Part::portraits, Part::map, Part::strip, Part::numbers}) {
        EXPECT_TRUE(shown(job).shows(part));
    }
    EXPECT_FALSE(shown(job).shows(Part::arrows));
    EXPECT_FALSE(shown(job).shows(Part::directions)) << "on the arc they point along time, and are read as ways";
    job.seeds = "seeds";
    EXPECT_TRUE(shown(job).shows(Part::arrows)) << "listed seeds are to be seen";
    job = job_of({.name = "", .filter = "temporal"});
    for (const Part part : {Part::portraits, Part::map, Part::strip, Part::numbers, Part::directions}) {
        EXPECT_FALSE(shown(job).shows(part)) << "nothing is known of objects";
    }
    EXPECT_TRUE(shown(job).shows(Part::arrows)) << "in place of the objects";
}

TEST(PartsOfAPlan, BesideThePictureOfAPageAreThePages) {
    app::RenderJob job;
    for (const auto& [path, page, on_picture] :
         {std::tuple("a.png", "", true), {"a.png", "a.html", true}, {"a.html", "", false}, {"", "a.html", false}}) {
        job.output.path = path;
        job.output.page = page;
        const app::LookPlan look = app::make_plan(job, test::header_of()).look;
        EXPECT_EQ(look.only_page, !on_picture) << path << page;
        for (const Part part : {Part::title, Part::legend, Part::strip, Part::ends, Part::explanation})
            EXPECT_EQ(look.shows(part), on_picture) << path << page;
        EXPECT_TRUE(look.shows(Part::portraits));
    }
}

TEST(BackgroundOfAPlan, IsThePagesBehindALightPicture) {
    const auto background = [](const char* theme, const char* path, std::optional<glm::vec4> given = {}) {
        app::RenderJob job = job_of({.name = "", .theme = theme});
        job.output.path = path;
        job.look.background = given;
        return app::make_plan(job, test::header_of()).look.picture.background;
    };
    EXPECT_EQ(background("light", "a.png"), glm::vec4(1));
    EXPECT_EQ(background("light", "a.html"), glm::vec4(0));
    EXPECT_EQ(background("dark", "a.html").a, 1);
    EXPECT_EQ(background("dark", "a.png", glm::vec4(0, 1, 0, 1)), glm::vec4(0, 1, 0, 1));
}

TEST(ScalesOfAPlan, AreFactorsOnWhatIsDrawn) {
    app::RenderJob job;
    const app::Plan usual = app::make_plan(job, test::header_of());
    job.look.opacity = 3;
    job.look.glyph_scale = 2;
    const app::Plan plan = app::make_plan(job, test::header_of());
    EXPECT_DOUBLE_EQ(plan.look.drawn_transfer.at(200).w, 3 * plan.look.transfer.at(200).w);
    EXPECT_DOUBLE_EQ(plan.look.glyphs.cap, 2 * usual.look.glyphs.cap);
    EXPECT_DOUBLE_EQ(plan.look.glyphs.frames, 2 * usual.look.glyphs.frames);
    EXPECT_FLOAT_EQ(plan.look.picture.glyphs.thickness, 2 * usual.look.picture.glyphs.thickness);
}

TEST(TexturesOfAPlan, AreTwoWhereEachPieceIsDrawnOnce) {
    app::RenderJob job;
    EXPECT_EQ(app::make_plan(job, test::header_of()).volume.textures(9), 2);
    EXPECT_EQ(app::make_plan(job, test::header_of()).volume.textures(0), 1);
    job.output.path = "a.gif";
    job.output.animate = 12;
    EXPECT_EQ(app::make_plan(job, test::header_of()).volume.textures(9), 9);
}

}  // namespace
}  // namespace vvr
