// What a picture shows: bricks, pieces, geometry and texts, as data. Nothing is drawn.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/annotation/ruler.h"
#include "core/space/layout.h"
#include "tests/unit/compose/observed.h"

namespace vvr {
namespace {

using app::Part;
using volume::Brick;

TEST(ComposedBricks, FollowFromTheirSettings) {
    constexpr auto frames = app::Time::Unit::frames;
    constexpr auto seconds = app::Time::Unit::seconds;
    struct Row {
        const char* name;
        app::BrickOptions bricks;
        std::vector<Brick> cut;
    };
    for (const Row& row : {
             Row{"a number", {.window = 4}, {{0, 25}, {25, 25}, {50, 25}, {75, 25}}},
             Row{"frames", {.length = app::Time{40, frames}}, {{0, 40}, {40, 40}, {80, 20}}},
             Row{"seconds", {.length = app::Time{2, seconds}}, {{0, 50}, {50, 50}}},
             Row{"rounded to layers", {.length = app::Time{1.98, seconds}}, {{0, 50}, {50, 50}}},
             Row{"longer than the clip", {.length = app::Time{9, seconds}}, {{0, 100}}},
         }) {
        app::RenderJob job;
        job.bricks = row.bricks;
        const std::vector<Brick> cut = test::composed_of(job, test::even_volume({32, 24}, 100)).bricks;
        EXPECT_EQ(cut, row.cut) << row.name;
        std::int64_t next = 0;
        for (const Brick& brick : cut) {
            EXPECT_EQ(brick.first, next) << row.name;
            next += brick.count;
        }
        EXPECT_EQ(next, 100) << row.name << ": each layer is in a brick";
    }
}

TEST(ComposedPieces, EndAtBricksAndKeyFrames) {
    app::RenderJob job;
    job.bricks.window = 2;
    app::Observation seen = test::observed(test::even_volume({32, 24}, 50));
    EXPECT_EQ(test::composed_of(job, seen).pieces, (std::vector<Brick>{{0, 25}, {25, 25}}));
    seen.keyframes = {{seen.last, 10}};
    const app::Composition composed = test::composed_of(job, seen);
    EXPECT_EQ(composed.pieces, (std::vector<Brick>{{0, 10}, {10, 15}, {25, 25}}));
    EXPECT_EQ(composed.first_piece, 0);
    EXPECT_EQ(composed.layers, 50);
    EXPECT_EQ(composed.textures, 2) << "one is filled while the other is drawn";
    job.look.show.remove(Part::volume);
    EXPECT_TRUE(test::composed_of(job, seen).pieces.empty());
}

TEST(ComposedPieces, OfASeriesAreCountedFromTheClipsStart) {
    app::RenderJob job;
    job.output.path = "####.png";
    job.bricks = {.window = 4, .length = app::Time{20, app::Time::Unit::frames}};
    app::Observation seen = test::observed(test::even_volume({32, 24}, 50));
    seen.first_brick = 3;
    const media::Frame frame{0, 0, Plane<std::uint8_t>({32, 24}), {}};
    seen.first = seen.last = std::make_shared<const media::Frame>(frame);
    const app::Composition composed = test::composed_of(job, seen);
    EXPECT_EQ(composed.bricks, (std::vector<Brick>{{0, 20}, {20, 20}, {40, 10}}));
    EXPECT_EQ(composed.first_piece, 3);
    EXPECT_EQ(composed.layers, 80) << "of the whole window, which is not full yet";
    EXPECT_EQ(composed.textures, 4) << "each is drawn again";
    EXPECT_FALSE(composed.frames_missing);
    seen.first = seen.last = std::make_shared<const media::Frame>();
    EXPECT_TRUE(test::composed_of(job, seen).frames_missing);
}

/// Of a volume with a seed, when the picture has this part alone.
app::Composition with_part(Part part) {
    app::RenderJob job;
    job.look.show = {part};
    job.bricks.window = 3;
    volume::Volume volume({32, 24}, {.capacity = 50, .keep_flow = true});
    for (int i = 0; i < 50; ++i) {
        fields::Field field = test::field_of(i, {32, 24}, 200);
        field.seeds = {{9, 9, 1, 1}};
        field.flow = {Plane<float>({32, 24}, 1), Plane<float>({32, 24}, 0)};
        volume.add(field);
    }
    return test::composed_of(job, volume);
}

TEST(ComposedParts, EachAddsItsOwn) {
    struct Row {
        Part part;
        bool (*shown)(const app::Composition&);
    };
    const Row rows[] = {
        {Part::volume, [](const auto& c) { return !c.pieces.empty(); }},
        {Part::arrows, [](const auto& c) { return !c.scene.arrows.empty(); }},
        {Part::tracelines, [](const auto& c) { return !c.scene.tracelines.empty(); }},
        {Part::floor, [](const auto& c) { return !c.scene.floor.darkness.empty(); }},
        {Part::ruler, [](const auto& c) { return !c.ticks.empty(); }},
        {Part::boxes, [](const auto& c) { return c.boxes; }},
        {Part::slices, [](const auto& c) { return c.slices.has_value(); }},
    };
    for (const Row& row : rows) {
        const std::string_view name = app::parts()[static_cast<std::size_t>(row.part)].name;
        EXPECT_TRUE(row.shown(with_part(row.part))) << name;
        for (const Row& other : rows) {
            if (&other == &row) continue;
            EXPECT_FALSE(other.shown(with_part(row.part))) << name << " shows another part";
        }
    }
    EXPECT_FALSE(with_part(Part::outline).scene.lines.empty());
    EXPECT_FALSE(with_part(Part::bricks).scene.lines.empty());
    EXPECT_TRUE(with_part(Part::volume).scene.lines.empty());
}

TEST(ComposedRuler, NeedsRoomForText) {
    app::RenderJob job;
    const auto ticks = [&](Size size) {
        job.picture.size = size;
        return test::composed_of(job, test::even_volume({32, 24}, 100)).ticks.size();
    };
    EXPECT_GE(ticks({1280, 800}), 3U);
    EXPECT_EQ(ticks({160, 100}), 0U);
}

TEST(ComposedPalette, ShowsChangesWhereThereAreNoObjects) {
    const app::RenderJob job;
    app::Observation seen = test::observed(test::even_volume({32, 24}, 50, 200));
    EXPECT_EQ(test::composed_of(job, seen).palette.front().a, 1);
    tracking::Event event;
    event.last = {49, 1.96};
    event.path = {{event.first, {4, 4}}, {event.last, {20, 9}}};
    event.tracks = {0};
    seen.events = app::events_between(std::array{event}, 0, 2);
    const app::Composition composed = test::composed_of(job, seen);
    EXPECT_LT(composed.palette.front().a, 1) << "what belongs to no object is fainter";
    EXPECT_EQ(composed.objects.events.size(), 1U);
    EXPECT_EQ(composed.objects.colours.size(), 1U);
    EXPECT_NEAR(composed.objects.end, 1.96, 1e-9);
    app::RenderJob plain;
    plain.look.colour = "transfer";
    EXPECT_TRUE(test::composed_of(plain, seen).palette.empty());
    plain.look.colour = "time";
    EXPECT_EQ(test::composed_of(plain, seen).palette.size(), 256U);
}

TEST(ComposedLettering, IsThePagesWhereThereIsNoOtherPicture) {
    app::RenderJob job;
    job.output.path = "a.html";
    const annotation::Lettering none = test::composed_of(job, test::even_volume({32, 24}, 50)).lettering;
    EXPECT_TRUE(none.labels.empty() && none.bars.empty() && none.pictures.empty());
}

TEST(ComposedLettering, TellsWhatNobodySaw) {
    app::RenderJob job;
    app::Observation seen = test::observed(test::even_volume({32, 24}, 50));
    seen.summary.damaged = 30;
    app::Plan plan = app::make_plan(job, {.field_size = seen.volume.size()});
    plan.field.masked = 0.34;
    const auto labels = app::compose(plan, seen).lettering.labels;
    EXPECT_TRUE(std::ranges::any_of(labels, [](const annotation::Label& label) {
        return label.text.starts_with("50 frames, 0.0 s to 2.0 s") &&
               label.text.ends_with("; 34 % of the scene masked; 30 damaged packets");
    }));
}

TEST(ComposedGaps, AreTheLongestWithTheirReasons) {
    volume::Volume volume({32, 24}, {800});
    int next = 0;
    for (const int missing : {30, 10, 50, 20, 40}) {
        for (int i = 0; i < 5; ++i, ++next) volume.add(test::field_of(next, {32, 24}, 200));
        for (int i = 0; i < missing; ++i, ++next) volume.add_missing(next, next / 25.0);
    }
    volume.add(test::field_of(next, {32, 24}, 200));
    app::Observation seen = test::observed(volume);
    app::Plan plan = app::make_plan({}, {.field_size = volume.size()});
    const auto lengths = [&] {
        std::vector<int> frames;
        for (const annotation::TimeGap& gap : app::explained_gaps(plan, seen))
            frames.push_back(static_cast<int>(std::lround((gap.end - gap.begin) * 25)) + 1);
        return frames;
    };
    EXPECT_EQ(lengths(), (std::vector<int>{50, 40, 30, 20}));
    EXPECT_EQ(app::explained_gaps(plan, seen).front().reason, "no signal");
    seen.missing = {{0, 99, condition::Kind::dropped}};
    EXPECT_EQ(app::explained_gaps(plan, seen).front().reason, "frames dropped");
    seen.missing.clear();
    plan.read.span.parts = {{0, 0.1}};
    EXPECT_EQ(app::explained_gaps(plan, seen).front().reason, "left out");
}

TEST(BusyTime, IsToldInTheTitleAndOnTheRuler) {
    const volume::Volume volume = test::day_with_pauses(800);
    const app::RenderJob job;
    const annotation::Lettering lettering = test::composed_of(job, volume).lettering;
    const auto tells = [&](const std::string& text) {
        return std::ranges::any_of(lettering.labels, [&](const annotation::Label& label) {
            return label.text.find(text) != std::string::npos;
        });
    };
    EXPECT_TRUE(tells("3:00 h without motion are shortened"));
    EXPECT_TRUE(tells("60 min idle"));
    EXPECT_TRUE(tells("with more room where something moves"));
    EXPECT_TRUE(std::ranges::find(lettering.labels, "0:00", &annotation::Label::text) != lettering.labels.end())
        << "a pause begins there, too";
}

TEST(Gaps, AreHatchedAndNamedOnTheRuler) {
    const volume::Volume volume = test::volume_with_gap(30, 60);
    app::RenderJob job;
    const auto layout = space::make_layout("horseshoe", space::shape_for(volume.size()));
    const app::Composition composed = test::composed_of(job, volume);
    EXPECT_EQ(std::ranges::count(composed.lettering.labels, "no signal", &annotation::Label::text), 1);
    const auto strokes =
        annotation::gap_marks(annotation::time_gaps(volume), *layout, composed.framing.edge, {1, 0, 0, 1});
    EXPECT_GT(strokes.size(), 20U);
    for (const scene::LineSegment& stroke : strokes) {
        const double t = layout->c_from_p(stroke.from).z;
        EXPECT_TRUE(t > 0.3 - 1e-6 && t < 0.6 + 1e-6) << t;
    }
    job.look.show.remove(app::Part::ruler);
    EXPECT_EQ(
        std::ranges::count(test::composed_of(job, volume).lettering.labels, "no signal", &annotation::Label::text), 0);
}

TEST(Lettering, SaysThatNothingMoves) {
    volume::Volume volume = test::even_volume({32, 24}, 50);
    const app::RenderJob job;
    const auto says_it = [&] {
        return std::ranges::count(test::composed_of(job, volume).lettering.labels, "nothing moves",
                                  &annotation::Label::text);
    };
    EXPECT_EQ(says_it(), 1);
    volume.add(test::field_of(50, {32, 24}, 255));
    EXPECT_EQ(says_it(), 0);
}

}  // namespace
}  // namespace vvr
