// What a page says of a picture, as data.
#include "cli/compose/page_content.h"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/compose/observed.h"

namespace vvr {
namespace {

/// A page of a volume, of which `change` changes the plan and what was observed.
template <class Change>
page::PageContent content_of(const Change& change, const char* output = "out/gate/a.html") {
    app::RenderJob job;
    job.input.names = {"in/RLC-823A_00_20261121080007.mp4"};
    job.output.path = output;
    app::Observation seen = test::observed(test::even_volume({32, 24}, 100, 200));
    app::ClipFacts clip{.field_size = seen.volume.size()};
    clip.info.name = job.input.names.front();
    seen.info.size = {320, 240};
    change(job);
    app::Plan plan = app::make_plan(job, clip);
    if constexpr (requires { change(plan, seen); }) change(plan, seen);
    return app::page_content(plan, seen, app::compose(plan, seen));
}

/// Changes the job, and then the plan and what was observed.
template <class OfJob, class OfPlan>
struct Change : OfJob, OfPlan {
    using OfJob::operator();
    using OfPlan::operator();
};
template <class OfJob, class OfPlan>
Change(OfJob, OfPlan) -> Change<OfJob, OfPlan>;

const auto as_it_is = [](app::RenderJob&) {};
const auto recorded = [](app::Plan&, app::Observation& seen) { seen.info.segments = {{"in/1.mp4", 0, 5, 0}}; };

TEST(PageContent, NamesCameraAndFileOnce) {
    constexpr const char* file = "RLC-823A_00_20261121080007.mp4";
    const auto expect = [](const page::PageContent& content, std::array<std::string, 4> wanted) {
        EXPECT_EQ((std::array{content.name, content.camera, content.heading, content.file}), wanted);
    };
    expect(content_of(as_it_is), {file, "RLC-823A", "", file});
    expect(content_of([](app::RenderJob& job) { job.look.title = "Hall"; }), {"Hall", "", "", file});
    expect(content_of([](app::RenderJob& job) { job.look.title = "Hall", job.output.page_camera = "gate"; }),
           {"Hall", "gate", "", file});
    expect(content_of([](app::RenderJob& job) { job.output.page_heading = "at the gate"; }),
           {file, "RLC-823A", "at the gate", file});
    expect(content_of(Change{as_it_is, recorded}), {file, "", "", ""});
    const Change two_files{[](app::RenderJob& job) { job.input.names.emplace_back("in/2.mp4"); },
                           [](app::Plan&, app::Observation& seen) { seen.info.unread = 1; }};
    EXPECT_EQ(content_of(two_files).file, "2 files, 1 could not be read");
}

TEST(PageContent, LinksAreRelativeToWhereThePageIsInTheEnd) {
    const Change all{[](app::RenderJob& job) {
                         job.output.page_place = "archive/2026/a.mp4.html";
                         job.output.page_index = "archive/index.html";
                     },
                     [](app::Plan& plan, app::Observation& seen) {
                         plan.page.plays_file = true;
                         plan.page.file_ending = ".mp4";
                         seen.info.segments = {{"archive/1 a.mp4", 0, 5, 0}, {"archive/2.mp4", 5, 5, 125}};
                     }};
    const page::PageContent content = content_of(all, "tmp/a.html");
    ASSERT_TRUE(content.index);
    EXPECT_EQ(content.index->url, "./../index.html");
    EXPECT_EQ(content.index->clip, "./2026/a.mp4");
    EXPECT_EQ(content.clip_url, "./../../in/RLC-823A_00_20261121080007.mp4");
    EXPECT_EQ(content.piece_extension, ".mp4");
    ASSERT_EQ(content.segments.size(), 1U) << "the second one is covered by another file";
    EXPECT_EQ(content.segments[0].url, "./../1%20a.mp4");
    EXPECT_EQ(content.segments[0].length, 5);
    const page::PageContent alone = content_of(as_it_is);
    EXPECT_FALSE(alone.index);
    EXPECT_EQ(alone.clip_url, "") << "there is no file to play";
}

TEST(PageContent, HasEventsWithWhatTheyDid) {
    EXPECT_FALSE(content_of(as_it_is).events) << "nobody searched for them";
    const auto with_events = [](app::Plan&, app::Observation& seen) {
        tracking::Event event;
        event.first = {10, 0.4};
        event.last = {60, 2.4};
        event.path = {{event.first, {2, 12}}, {event.last, {30, 12}}};
        event.path_length = 28;
        event.tracks = {0};
        seen.events = app::events_between(std::array{event}, 0, 4);
        seen.not_chosen = {{1, 2}, {2, 3}};
        seen.crops.keep(0, {{30, 1.2}, {2, 2, 12, 12}, 1},
                        {30, 1.2, Plane<std::uint8_t>({32, 24}), Plane<Bgr>({32, 24})});
    };
    const page::PageContent content = content_of(Change{as_it_is, with_events});
    ASSERT_TRUE(content.events);
    ASSERT_EQ(content.events->size(), 1U);
    ASSERT_EQ(content.activities.size(), 1U);
    EXPECT_NE(content.activities[0].find("went to the right"), std::string::npos) << content.activities[0];
    EXPECT_EQ(content.number_of(0), 1U);
    EXPECT_EQ(content.colours.size(), 1U);
    EXPECT_EQ(content.not_chosen, 2U);
    ASSERT_EQ(content.portraits.size(), 1U);
    EXPECT_FALSE(content.portraits[0].empty());
    EXPECT_EQ(content.overlay.portraits.size(), 1U);
}

TEST(PageContent, HasTheVolumeOfAWholeClip) {
    const page::PageContent content = content_of(as_it_is);
    const Json& turning = content.turning;
    EXPECT_EQ(turning["size"], (Json{32, 24, 100}));
    EXPECT_EQ(turning["scale"], (Json{1, 1, 1}));
    ASSERT_EQ(turning["frames"].size(), 101U) << "the first of each layer, and the last";
    EXPECT_EQ(turning["frames"][50], 50);
    EXPECT_EQ(turning["frames"].back(), 99);
    EXPECT_EQ(turning["schemes"].size(), 2U) << "light and dark";
    EXPECT_FALSE(turning["ticks"].empty());
    EXPECT_TRUE(content_of([](app::RenderJob& job) { job.output.flat_page = true; }).turning.is_null());
    EXPECT_TRUE(content_of([](app::RenderJob& job) { job.picture.view.fov = 0; }).turning.is_null());
    EXPECT_TRUE(content_of([](app::RenderJob& job) { job.look.colour = "transfer"; }).turning.is_null());
}

TEST(PageContent, MakesTheVolumeSmallerUntilThePageHasRoom) {
    const Change noise{as_it_is, [](app::Plan&, app::Observation& seen) {
                           constexpr Size size{160, 120};
                           std::minstd_rand random(1);
                           volume::Volume volume(size, {});
                           for (int i = 0; i < 120; ++i) {
                               fields::Field field = test::field_of(i, size, 0);
                               for (std::uint8_t& value : field.scalar.pixels())
                                   value = static_cast<std::uint8_t>(random() % 4 == 0 ? random() % 256 : 0);
                               volume.add(field);
                           }
                           seen = test::observed(volume);
                       }};
    const Json turning = content_of(noise).turning;
    const std::size_t letters =
        turning["levels"].get<std::string>().size() + turning["owners"].get<std::string>().size();
    EXPECT_LE(letters, 310'000U);
    EXPECT_GE(letters, 60'000U) << "not smaller than it has to be";
}

TEST(PageContent, PutsMomentsAndTimesIntoThePicture) {
    const page::PageContent content = content_of(as_it_is);
    const page::Overlay& overlay = content.overlay;
    ASSERT_EQ(overlay.sections.size(), 101U) << "one for each layer, and the end";
    EXPECT_TRUE(std::ranges::is_sorted(overlay.sections, {}, &page::Overlay::Section::seconds));
    EXPECT_NEAR(overlay.sections.back().seconds, 99 / 25.0, 1e-9);
    const Size size = app::RenderJob().picture.size;
    for (const page::Overlay::Section& section : overlay.sections) {
        for (const glm::dvec2& corner : section.corners)
            EXPECT_TRUE(corner.x >= 0 && corner.x <= size.width && corner.y >= 0 && corner.y <= size.height);
    }
    ASSERT_GE(overlay.notes.size(), 3U);
    EXPECT_EQ(overlay.notes[0].text, "0.0 s") << "the first time matters most";
    for (const page::Overlay::Note& note : overlay.notes) EXPECT_NEAR(glm::length(note.out), 1, 1e-9);
    EXPECT_EQ(content.shown, (Size{320, 240}));
    EXPECT_EQ(content.field, (Size{32, 24}));
    EXPECT_TRUE(overlay.map.empty()) << "the scene is not known";
    const Change with_scene{as_it_is, [](app::Plan&, app::Observation& seen) { seen.scene = Plane<Bgr>({32, 24}); }};
    const page::Overlay mapped = content_of(with_scene).overlay;
    EXPECT_FALSE(mapped.map.empty());
    EXPECT_EQ(mapped.scene.size(), mapped.map.size());
    const auto without_ruler = [](app::RenderJob& job) { job.look.show.remove(app::Part::ruler); };
    EXPECT_TRUE(content_of(without_ruler).overlay.notes.empty());
}

}  // namespace
}  // namespace vvr
