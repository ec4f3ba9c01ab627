#include "core/base/file.h"

#include <array>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(ReadFile, TakesNoMoreFromAPipeThanItMay) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const std::string text(100, 'x');
    ASSERT_EQ(::write(ends[1], text.data(), text.size()), 100);
    ::close(ends[1]);
    const std::string path = "/dev/fd/" + std::to_string(ends[0]);
    test::expect_error(ErrorCode::file_too_large, [&] { read_file(path, 99); }, {path});
    ::close(ends[0]);
}

TEST(LockFile, HasOneOwner) {
    const auto path = std::filesystem::temp_directory_path() / ("vvr-lock-" + std::to_string(::getpid()));
    const int first = ::open(path.c_str(), O_RDWR | O_CREAT, 0600);
    const int second = ::open(path.c_str(), O_RDWR);
    EXPECT_EQ(lock_file(first, false), 0);
    EXPECT_EQ(lock_file(second, false), EWOULDBLOCK);
    ::close(first);
    EXPECT_EQ(lock_file(second, true), 0);
    ::close(second);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace vvr
