#include "core/base/file.h"

#include <array>
#include <string>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/base/digest.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"

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
    const test::TempFolder folder;
    const std::string path = folder / "lock";
    const int first = ::open(path.c_str(), O_RDWR | O_CREAT, 0600);
    const int second = ::open(path.c_str(), O_RDWR);
    EXPECT_EQ(lock_file(first, false), 0);
    EXPECT_EQ(lock_file(second, false), EWOULDBLOCK);
    ::close(first);
    EXPECT_EQ(lock_file(second, true), 0);
    ::close(second);
}

TEST(Digest, OfAFileIsThatOfItsBytes) {
    const test::TempFolder folder;
    // As sha256sum prints them: of nothing, of "abc", and of 2 MiB and a byte, which are read in parts.
    const std::pair<std::string, std::string> known[] = {
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {std::string((2 << 20) + 1, 'x'), "71ac24a75f6bc57bc51b43b3d13c3009aa243986b77a92102a3097c9e53123e9"}};
    for (const auto& [bytes, digest] : known) {
        test::write_bytes(folder / "file", bytes);
        EXPECT_EQ(hex_sha256_of_file(folder / "file"), digest);
        EXPECT_EQ(hex_sha256(bytes), digest);
    }
    const std::string none = folder / "none";
    test::expect_error(ErrorCode::file_not_found, [&] { hex_sha256_of_file(none); }, {none});
}

}  // namespace
}  // namespace vvr
