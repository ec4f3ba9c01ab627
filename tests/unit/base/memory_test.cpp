#include "core/base/memory.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;

TEST(ControlGroup, LimitsMemoryByItsLowestLimit) {
    const test::TempFolder folder;
    constexpr auto unlimited = std::numeric_limits<std::int64_t>::max();
    const auto write = [&](const std::string& name, const std::string& text) {
        fs::create_directories(fs::path(folder / name).parent_path());
        test::write_bytes(folder / name, text);
    };
    const auto limit = [&] { return control_group_memory(folder / "cgroup", folder / "groups"); };
    EXPECT_EQ(limit(), unlimited) << "no control groups";
    write("cgroup", "4:memory:/old\n0::/system.slice/vvr-archive.service\n");
    write("groups/system.slice/vvr-archive.service/memory.max", "max\n");
    EXPECT_EQ(limit(), unlimited);
    write("groups/system.slice/memory.max", "3000000000\n");
    EXPECT_EQ(limit(), 3'000'000'000) << "of the group above it";
    write("groups/system.slice/vvr-archive.service/memory.max", "1000000000\n");
    EXPECT_EQ(limit(), 1'000'000'000);
    write("cgroup", "0::/\n");
    write("groups/memory.max", "2000000000\n");
    EXPECT_EQ(limit(), 2'000'000'000) << "in a container";
    write("groups/old/memory.max", "1\n");
    write("cgroup", "4:memory:/old\n");
    EXPECT_EQ(limit(), unlimited) << "another version";
}

}  // namespace
}  // namespace vvr
