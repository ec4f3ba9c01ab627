#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

constexpr Size size{64, 48};

/// A textured square that crosses an empty scene.
media::Frame walker_frame(std::int64_t index) {
    media::Frame frame = test::flat_frame(size, index, 90);
    const double left = 2 + 1.5 * static_cast<double>(index);
    for (int j = 12; j < 36; ++j) {
        for (int i = 0; i < size.width; ++i) {
            if (i < left || i >= left + 20) continue;
            frame.grey.at(i, j) = static_cast<std::uint8_t>(140 + 0.4 * test::texture(i - left, j));
        }
    }
    return frame;
}

fields::FrameReader reader(int count) {
    return test::frames_of(count, walker_frame);
}

fields::EmptyScene empty_scene() {
    return test::scene_of(test::flat_frame(size, 0, 90));
}

std::vector<fields::Field> fields_of(int count, const fields::FieldOptions& options) {
    return test::fields_of(reader(count), empty_scene(), options);
}

void expect_same(const fields::Field& a, const fields::Field& b) {
    EXPECT_EQ(a.index, b.index);
    EXPECT_EQ(a.pts, b.pts);
    EXPECT_TRUE(test::same(a.scalar, b.scalar));
    EXPECT_TRUE(test::same(a.flow.u, b.flow.u));
    EXPECT_TRUE(test::same(a.flow.v, b.flow.v));
    EXPECT_EQ(a.seeds, b.seeds);
}

TEST(Pipeline, GivesEveryFrameOnceInOrder) {
    const std::vector<fields::Field> fields = fields_of(30, {.threads = 4});
    ASSERT_EQ(fields.size(), 30U);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        EXPECT_EQ(fields[f].index, static_cast<std::int64_t>(f));
        EXPECT_DOUBLE_EQ(fields[f].pts, static_cast<double>(f) / 10);
        EXPECT_EQ(fields[f].scalar.size(), size);
        EXPECT_GT(test::lit(fields[f].scalar), 100);
    }
}

TEST(Pipeline, DoesNotDependOnTheNumberOfThreads) {
    const std::vector<fields::Field> one = fields_of(30, {.threads = 1});
    EXPECT_FALSE(one[15].seeds.empty());
    for (const int threads : {2, 4}) {
        const std::vector<fields::Field> many = fields_of(30, {.threads = threads});
        ASSERT_EQ(many.size(), one.size());
        for (std::size_t f = 0; f < one.size(); ++f) expect_same(one[f], many[f]);
    }
}

TEST(Pipeline, SeedsFollowTheWalker) {
    const std::vector<fields::Field> fields =
        fields_of(30, {.seeds = {.grid = 6, .min_magnitude = 0.5, .select = {}}, .threads = 2});
    ASSERT_GT(fields[15].seeds.size(), 4U);
    double u = 0;
    for (const fields::Seed& seed : fields[15].seeds) {
        u += seed.u;
        EXPECT_NE(fields[15].scalar.at(static_cast<int>(seed.x), static_cast<int>(seed.y)), 0);
    }
    EXPECT_GT(u / static_cast<double>(fields[15].seeds.size()), 0.5) << "to the right";
}

TEST(Pipeline, FlowOnlyWhereAskedFor) {
    fields::FieldOptions options{.threads = 2};
    options.flow.every = 8;
    const std::vector<fields::Field> some = fields_of(30, options);
    const std::vector<fields::Field> all = fields_of(30, {.threads = 2});
    for (std::size_t f = 0; f < some.size(); ++f) {
        if (f % 8 == 0) {
            expect_same(some[f], all[f]);
        } else {
            EXPECT_TRUE(some[f].flow.u.empty());
            EXPECT_TRUE(some[f].seeds.empty());
        }
    }
    options.flow.method = "none";
    EXPECT_TRUE(fields_of(3, options)[0].flow.u.empty());
}

TEST(Pipeline, OneFrameAndNoFrame) {
    EXPECT_EQ(fields_of(1, {.threads = 2}).size(), 1U);
    EXPECT_EQ(fields_of(0, {.threads = 2}).size(), 0U);
}

TEST(Pipeline, SinkIsNeverEnteredTwice) {
    std::atomic<int> inside = 0;
    const auto sink = [&](const media::SharedFrame&, fields::Field&&) {
        EXPECT_EQ(++inside, 1);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        --inside;
    };
    EXPECT_EQ(fields::compute_fields(reader(20), empty_scene(), {.threads = 4}, sink), 20);
}

TEST(Pipeline, MemoryIsBounded) {
    std::atomic<std::int64_t> read = 0;
    std::int64_t delivered = 0;
    std::int64_t most = 0;
    const fields::FrameReader frames = [&, next = std::int64_t{0}]() mutable -> fields::FrameJob {
        if (next == 200) return {};
        ++read;
        return [index = next++] { return walker_frame(index % 20); };
    };
    fields::compute_fields(frames, empty_scene(), {.threads = 2}, [&](const media::SharedFrame&, fields::Field&&) {
        most = std::max(most, read - delivered++);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    });
    EXPECT_LT(most, 7 + 2 * 2 + 2) << "what the flow looks ahead and what is on its way";
}

TEST(Pipeline, ErrorsOfSinkAndSourceComeThrough) {
    const auto run = [](const fields::FrameReader& frames) {
        fields::compute_fields(frames, empty_scene(), {.threads = 2},
                               [](const media::SharedFrame&, fields::Field&& field) {
                                   if (field.index == 3) throw std::runtime_error("the disk is full");
                               });
    };
    EXPECT_THROW(run(reader(40)), std::runtime_error);
    EXPECT_THROW(run([]() -> fields::FrameJob { throw std::range_error("the cable is cut"); }), std::range_error);
    const auto bad_frame = []() -> media::Frame { throw std::domain_error("bad frame"); };
    EXPECT_THROW(run([&]() -> fields::FrameJob { return bad_frame; }), std::domain_error);
}

}  // namespace
}  // namespace vvr
