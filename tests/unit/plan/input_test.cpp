// What a plan says of its footage: names, cameras, clocks, areas, settings of an extraction.
#include "cli/plan/input.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "cli/plan/make_plan.h"
#include "core/image/picture.h"
#include "tests/support/errors.h"
#include "tests/support/zone.h"
#include "tests/unit/plan/header.h"

namespace vvr {
namespace {

TEST(ShownName, TellsNeitherFoldersNorWhoMaySeeIt) {
    EXPECT_EQ(app::shown_name("/srv/cctv/Tür 1.avi"), "Tür 1.avi");
    EXPECT_EQ(app::shown_name("frames/%05d.png"), "%05d.png");
    EXPECT_EQ(app::shown_name("folder/"), "folder");
    EXPECT_EQ(app::shown_name("-"), "stdin");
    EXPECT_EQ(app::shown_name("rtsp://admin:secret@camera"), "a clip");
    EXPECT_EQ(app::shown_name("rtsp://admin:secret@camera/hall?token=abc"), "hall");

    media::VideoInfo clip;
    clip.name = "rtsp://admin:secret@camera/hall?token=abc";
    EXPECT_EQ(app::title_of("", clip), "hall");
    EXPECT_EQ(app::title_of("asked for", clip), "asked for");
}

TEST(CameraOfAPlan, IsNamedWhereItIsShown) {
    constexpr const char* file = "in/RLC-823A_00_20261121080007.mp4";
    struct Row {
        const char* output;
        const char* asked;  ///< of the page
        const char* named;  ///< by the user
        const char* camera;
    };
    for (const auto& [output, asked, named, camera] : {
             Row{"a.html", "", "", "RLC-823A"},
             Row{"a.html", "", "gate", "gate"},
             Row{"a.html", "Hall", "gate", "Hall"},
             Row{"a.png", "Hall", "gate", ""},
         }) {
        app::RenderJob job;
        job.input.names = {file};
        job.input.camera = named;
        job.output.path = output;
        job.output.page_camera = asked;
        EXPECT_EQ(app::make_plan(job, test::header_of()).read.camera, camera) << output << asked << named;
        job.output.report = "r.json";
        EXPECT_NE(app::make_plan(job, test::header_of()).read.camera, "") << "a report names it";
    }
}

TEST(ClockOfAPlan, IsShownOnlyIfKnown) {
    using From = app::StartTime::From;
    constexpr std::int64_t morning = 1'795'248'000;  // 2026-11-21 08:00:00 UTC
    const test::InZone utc("UTC");
    const app::ClipFacts unknown = test::header_of();
    app::ClipFacts named = unknown;
    named.info.began = morning;
    named.info.began_source = ClockSource::file_name;
    app::ClipFacts copied = unknown;
    copied.info.created = morning;
    copied.info.modified = morning + 60;
    struct Row {
        From from;
        const app::ClipFacts& clip;
        std::int64_t begin;  ///< 0 = no clock
        ClockSource source = ClockSource::none;
    };
    for (const Row& row : {
             Row{From::automatic, unknown, 0},
             Row{From::automatic, named, morning, ClockSource::file_name},
             Row{From::automatic, copied, 0},
             Row{From::none, named, 0},
             Row{From::recorded, named, morning, ClockSource::file_name},
             Row{From::container, copied, morning, ClockSource::container},
             Row{From::modified, copied, morning + 60, ClockSource::modified},
             Row{From::given, named, 77, ClockSource::user},
         }) {
        app::RenderJob job;
        job.look.start_time = {row.from, Clock(77)};
        const app::ReadPlan read = app::make_plan(job, row.clip).read;
        EXPECT_EQ(read.wants_clock, row.from != From::none);
        EXPECT_EQ(read.clock.has_value(), row.begin != 0) << static_cast<int>(row.from);
        if (!read.clock) continue;
        EXPECT_EQ(read.clock->begin, row.begin);
        EXPECT_EQ(read.clock->source, row.source);
        EXPECT_EQ(read.clock->lasts, 10);
    }
    for (const auto& [from, word] :
         {std::pair(From::recorded, "recorded"), {From::container, "container"}, {From::modified, "modified"}}) {
        app::RenderJob job;
        job.look.start_time.from = from;
        test::expect_error(ErrorCode::time_of_day_unknown, [&] { app::make_plan(job, unknown); }, {word, "'gate.avi'"});
    }
}

TEST(AreasOfAPlan, AreToldWithTheirShareOfTheScene) {
    app::RenderJob job;
    const app::FieldPlan whole = app::make_plan(job, test::header_of()).field;
    EXPECT_TRUE(whole.areas.empty() && !whole.has_roi && !whole.has_region);
    EXPECT_EQ(whole.masked, 0);
    job.fields.mask = "0,0 160,0 160,240 0,240";
    job.settings = {{"mask", job.fields.mask}};
    const app::FieldPlan half = app::make_plan(job, test::header_of()).field;
    EXPECT_TRUE(half.has_region && !half.has_roi);
    ASSERT_EQ(half.areas.size(), 1U);
    EXPECT_EQ(half.areas[0].option, "mask");
    EXPECT_EQ(half.areas[0].value, job.fields.mask);
    EXPECT_EQ(half.areas[0].sha256.size(), 64U);
    EXPECT_NEAR(half.masked.value(), 0.5, 0.05);
    // Of an extraction, it is known only that something was left out.
    app::ClipFacts clip = test::header_of();
    clip.extracted = job.settings;
    const app::FieldPlan extracted = app::make_plan({}, clip).field;
    ASSERT_EQ(extracted.areas.size(), 1U);
    EXPECT_EQ(extracted.areas[0].sha256, "");
    EXPECT_FALSE(extracted.masked);
}

TEST(ExtractionOfAPlan, FixesItsSettings) {
    app::RenderJob job;
    app::ClipFacts clip = test::header_of();
    clip.span = {.start = 2, .end = 7};
    EXPECT_EQ(app::make_plan(job, clip).read.span.start, 2) << "of a clip, the span in seconds counts";
    clip.extracted = {{"filter", "edges"}, {"threshold", "31"}};
    job.settings = {{"threshold", "24"}, {"size", ""}};
    const app::Plan plan = app::make_plan(job, clip);
    EXPECT_EQ(plan.field.filter->name, "edges");
    EXPECT_EQ(image::value_of(plan.output.settings, "threshold"), "31");
    EXPECT_EQ(std::ranges::count(plan.output.settings, "size", &image::Metadata::value_type::first), 0)
        << "what has no value is not recorded";
    EXPECT_EQ(plan.read.span.start, 0);
}

}  // namespace
}  // namespace vvr
