#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/lock_file.h"
#include "core/dataset/data_folder.h"
#include "core/dataset/manifest.h"
#include "core/dataset/stored_fields.h"
#include "core/fields/seed_list.h"
#include "tests/support/errors.h"
#include "tests/support/planes.h"
#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;

constexpr Size size{9, 5};

fields::Field field_of(std::int64_t index) {
    fields::Field field{index, 0.04 * static_cast<double>(index) + 1.0 / 3, Plane<std::uint8_t>(size), {}, {}};
    for (std::size_t i = 0; i < field.scalar.pixels().size(); ++i) {
        field.scalar.pixels()[i] = static_cast<std::uint8_t>(7 * i + static_cast<std::size_t>(index));
    }
    field.flow = {Plane<float>(size, 0.1F), Plane<float>(size, static_cast<float>(index))};
    field.seeds = {{1, 2, 0.1F, static_cast<float>(index)}};
    return field;
}

media::Frame frame_of(std::int64_t index) {
    const auto level = static_cast<std::uint8_t>(index);
    return {index, field_of(index).pts, Plane<std::uint8_t>(size), Plane<Bgr>(size, {level, 20, 200})};
}

dataset::Manifest manifest_of() {
    dataset::Manifest manifest;
    manifest.clip = {
        .name = {}, .container = "avi", .codec = "ffv1", .size = {90, 50}, .rate = 25, .duration = 0.4, .frames = 10};
    manifest.field_size = size;
    manifest.settings = {{"filter", "difference"}};
    return manifest;
}

class Store : public testing::Test {
  protected:
    std::string write(const std::string& name, std::int64_t begin, std::int64_t end) const {
        dataset::DataFolder data(folder / name, 2);
        for (std::int64_t i = begin; i < end; ++i) data.add(frame_of(i), field_of(i));
        data.close(manifest_of(), {});
        return folder / name;
    }

    test::TempFolder folder;
};

TEST_F(Store, GivesBackWhatItTook) {
    const std::vector<std::string> parts{write("a", 0, 4), write("b", 4, 10)};
    dataset::StoredFields stored(parts);
    EXPECT_EQ(stored.info().frames, 10);
    EXPECT_EQ(stored.interval(3), 4);
    std::int64_t next = 0;
    const fields::FieldSummary summary =
        stored.read({.every = 2}, [&](const media::SharedFrame& frame, fields::Field&& field) {
            const fields::Field expected = field_of(next);
            EXPECT_EQ(field.index, next);
            EXPECT_EQ(field.pts, expected.pts);
            EXPECT_TRUE(test::same(field.scalar, expected.scalar));
            EXPECT_EQ(field.seeds, next % 2 == 0 ? expected.seeds : std::vector<fields::Seed>{});
            EXPECT_EQ(field.flow.v.empty(), next % 2 == 1);
            if (next == 0 || next == 9) {
                EXPECT_TRUE(test::same(frame->colour, frame_of(next).colour));
            }
            ++next;
        });
    EXPECT_EQ(summary.frames, 10);
}

TEST_F(Store, KeepsTheSceneOfEachView) {
    const auto scene_of = [](const Bgr& colour) {
        const auto grey = static_cast<std::uint8_t>(fields::brightness_of(colour));
        return fields::Reference(fields::Planes{Plane<std::uint8_t>(size, grey), Plane<Bgr>(size, colour)});
    };
    fields::Reference day = scene_of({20, 90, 200});
    day.others.push_back(scene_of({70, 70, 70}));
    {
        dataset::DataFolder data(folder / "dusk", 2);
        for (std::int64_t i = 0; i < 4; ++i) {
            fields::Field field = field_of(i);
            field.view = i >= 2 ? 1 : 0;
            if (i == 2) field.before = condition::Kind::moved;
            data.add(frame_of(i), field);
        }
        dataset::Manifest manifest = manifest_of();
        manifest.colour = true;
        data.close(manifest, day);
    }
    const std::vector<std::string> parts{folder / "dusk"};
    dataset::StoredFields stored(parts);
    const fields::FieldSummary summary =
        stored.read({.every = 2}, [&](const media::SharedFrame& frame, const fields::Field& field) {
            EXPECT_EQ(field.view, frame->index >= 2 ? 1 : 0);
            EXPECT_EQ(field.before, frame->index == 2 ? condition::Kind::moved : condition::Kind::no_signal);
        });
    EXPECT_TRUE(test::same(summary.reference.colour, day.colour));
    ASSERT_EQ(summary.reference.others.size(), 1);
    EXPECT_TRUE(test::same(summary.reference.others.front().colour, day.others.front().colour));
    EXPECT_TRUE(test::same(summary.reference.others.front().grey, day.others.front().grey));
}

TEST_F(Store, WithoutCloseNothingStays) {
    {
        dataset::DataFolder data(folder / "a", 1);
        data.add(frame_of(0), field_of(0));
        EXPECT_TRUE(dataset::is_data_folder(folder / "a"));
        const std::vector<std::string> names{folder / "a"};
        EXPECT_THROW(dataset::StoredFields{names}, Error);
    }
    EXPECT_EQ(folder.files(), 0);
}

TEST_F(Store, ReplacesOlderDataOnlyByCompleteOnes) {
    const std::vector<std::string> names{write("a", 0, 4)};
    const fs::path a = names.front();
    const auto frames = [&] {
        return dataset::StoredFields(names).read({.every = 2}, [](const auto&, const auto&) {}).frames;
    };
    std::ofstream(a / "notes.txt") << "mine";
    const auto count = [&] { return std::distance(fs::recursive_directory_iterator(a), {}); };
    const auto files = count();
    {
        dataset::DataFolder data(a, 2);
        data.add(frame_of(0), field_of(0));
        EXPECT_EQ(frames(), 4) << "the older data are gone before there are others";
    }
    EXPECT_EQ(frames(), 4);
    EXPECT_EQ(count(), files);
    // The older data can't be moved out of the way, after some have been.
    {
        dataset::DataFolder data(a, 2);
        data.add(frame_of(0), field_of(0));
        fs::create_directories(a / ".vvr-older" / dataset::stored::seeds / "x");
        EXPECT_THROW(data.close(manifest_of(), {}), Error);
    }
    EXPECT_EQ(frames(), 4);
    EXPECT_EQ(count(), files);
    write("a", 0, 7);
    EXPECT_EQ(frames(), 7);
    EXPECT_TRUE(fs::exists(a / "notes.txt"));
    EXPECT_FALSE(fs::exists(a / ".vvr-new"));
    EXPECT_FALSE(fs::exists(a / ".vvr-older"));
}

TEST_F(Store, IsWrittenByOneAtATime) {
    const std::string name = folder / "a";
    {
        dataset::DataFolder data(name, 1);
        data.add(frame_of(0), field_of(0));
        test::expect_error(ErrorCode::file_locked, [&] { dataset::check_data_folder(name); }, {name, "vvr extract"});
        test::expect_error(ErrorCode::file_locked, [&] { dataset::DataFolder(name, 1); }, {name, "vvr extract"});
        data.close(manifest_of(), {});
    }
    const std::vector<std::string> names{name};
    EXPECT_EQ(dataset::StoredFields(names).read({}, [](const auto&, const auto&) {}).frames, 1);
    const auto is_hidden = [](const fs::directory_entry& entry) {
        return entry.path().filename().string().starts_with('.');
    };
    EXPECT_TRUE(std::ranges::none_of(fs::directory_iterator(name), is_hidden)) << "a lock stays";
    EXPECT_NO_THROW(dataset::check_data_folder(name));
}

TEST_F(Store, GoesOnWhereARunWasKilled) {
    const fs::path name = folder / "a";
    const pid_t child = ::fork();
    if (child == 0) {
        fs::create_directory(name);
        const auto lock = LockFile::try_take(name, dataset::stored::manifest);
        ::_exit(lock ? 0 : 1);  // without a destructor, as SIGKILL would
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    ASSERT_FALSE(fs::is_empty(name));
    { const dataset::DataFolder data(name, 1); }
    EXPECT_TRUE(fs::is_empty(name)) << "it held nothing but a lock";
}

TEST_F(Store, ListsReplaceSeeds) {
    const std::vector<std::string> whole{write("a", 0, 10)};
    const std::vector<std::string> rest{write("b", 4, 10)};
    fields::ListedSeeds listed(std::make_unique<dataset::StoredFields>(rest), whole.front() + "/seeds", {}, true);
    EXPECT_EQ(listed.interval(4), 2);
    fs::remove(fs::path(whole.front()) / dataset::stored::seed_file(6));
    fields::ListedSeeds fewer(std::make_unique<dataset::StoredFields>(rest), whole.front() + "/seeds", {}, true);
    std::size_t seeds = 0;
    fewer.read({.flow = false, .every = 2},
               [&](const media::SharedFrame&, fields::Field&& field) { seeds += field.seeds.size(); });
    EXPECT_EQ(seeds, 2U);
}

TEST_F(Store, AListIsSharedByAllFrames) {
    const std::vector<std::string> whole{write("a", 0, 10)};
    const std::string list = whole.front() + "/seeds/000004.txt";
    const auto seeds_of = [&](const fields::SeedOptions& options, bool on_object) {
        std::vector<fields::Seed> seeds;
        fields::ListedSeeds shared(std::make_unique<dataset::StoredFields>(whole), list, options, on_object);
        shared.read({.flow = false, .every = 2}, [&](const media::SharedFrame&, fields::Field&& field) {
            for (const fields::Seed& seed : field.seeds) seeds.push_back(seed);
        });
        return seeds;
    };
    const std::vector<fields::Seed> all = seeds_of({.min_magnitude = 0, .select = {}}, false);
    ASSERT_EQ(all.size(), 5U) << "each frame that has a flow";
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].x, 1);
        EXPECT_EQ(all[i].u, 0.1F);
        EXPECT_EQ(all[i].v, 2.F * static_cast<float>(i)) << "the flow of its own frame";
    }
    EXPECT_EQ(seeds_of({.min_magnitude = 5, .select = {}}, false).size(), 2U) << "of frames 6 and 8";
    EXPECT_EQ(seeds_of({.min_magnitude = 0, .select = {}}, true).size(), 5U)
        << "there is something in each frame at this point";
}

TEST(ManifestText, ReadsWhatItWrote) {
    dataset::Manifest manifest = manifest_of();
    manifest.frames = {{3, 1.0 / 3, 2}, {4, 0.1 + 0.3, {}}, {9, 0.8, {}, 0, condition::Kind::frozen, 4}};
    const dataset::Manifest read = dataset::parse_manifest(dataset::format_manifest(manifest), "m");
    EXPECT_EQ(read.frames, manifest.frames);
    EXPECT_EQ(read.settings, manifest.settings);
    EXPECT_EQ(read.field_size, size);
    EXPECT_EQ(dataset::format_manifest(read), dataset::format_manifest(manifest));
}

TEST(ManifestText, HasNoValueThatCannotBe) {
    dataset::Manifest manifest = manifest_of();
    for (int i = 0; i < 6; ++i) manifest.frames.push_back({i, 0.1 * i, 0});
    const nlohmann::json good = nlohmann::json::parse(dataset::format_manifest(manifest));
    const auto refuse = [&](const char* patch, ErrorCode code, std::initializer_list<std::string_view> facts) {
        const std::string text = good.patch(nlohmann::json::parse(patch)).dump();
        test::expect_error(
            code, [&] { dataset::parse_manifest(text, "m.json"); }, facts);
    };
    constexpr ErrorCode invalid = ErrorCode::file_invalid;
    refuse(R"([{"op": "replace", "path": "/frames/3/pts", "value": null}])", invalid, {"'frames[3].pts'", "null"});
    refuse(R"([{"op": "replace", "path": "/frames/3/pts", "value": 0.15}])", invalid,
           {"frame 3, 0.15 s", "frame 2, 0.2 s"});
    refuse(R"([{"op": "replace", "path": "/frames/5/pts", "value": 1e300}])", invalid, {"'frames[5].pts'", "1e+300"});
    refuse(R"([{"op": "remove", "path": "/frames/3"}])", invalid, {"frame 4", "frame 2"});
    refuse(R"([{"op": "add", "path": "/frames/3/gap", "value": 1}])", invalid, {"frame 3", "frame 2"});
    refuse(R"([{"op": "add", "path": "/frames/3/gap", "value": 0}])", invalid, {"'frames[3].gap'", "0"});
    refuse(R"([{"op": "replace", "path": "/frames", "value": []}])", ErrorCode::no_frame, {});
    refuse(R"([{"op": "replace", "path": "/field_width", "value": 1e300}])", invalid, {"'field_width'", "1e+300"});
    refuse(R"([{"op": "replace", "path": "/clip/rate", "value": "fast"}])", invalid, {"'clip.rate'", "\"fast\""});
    refuse(R"([{"op": "remove", "path": "/settings"}])", invalid, {"'settings'"});
    refuse(R"([{"op": "replace", "path": "/format_version", "value": 1}])", invalid, {"format_version", "1", "2"});
    refuse(R"([{"op": "replace", "path": "/complete", "value": false}])", invalid, {});
    test::expect_error(invalid, [] { dataset::parse_manifest("{ junk", "m.json"); }, {"'m.json'", "`vvr extract`"});
}

}  // namespace
}  // namespace vvr
