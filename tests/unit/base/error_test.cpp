#include "core/base/error.h"

#include <cerrno>
#include <new>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/memory.h"

namespace vvr {
namespace {

TEST(ErrorCodes, HaveNamesOfTheirOwnAndAreFoundByThem) {
    std::set<std::string> names;
    for (const ErrorRow& row : error_rows()) {
        const std::string name = row.name;
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string::npos) << name;
        EXPECT_EQ(find_error_code(name), row.code);
        EXPECT_FALSE(row.meaning.empty()) << name;
    }
    EXPECT_FALSE(find_error_code("not-a-code"));
}

TEST(ErrorCodes, AreOfAKind) {
    EXPECT_EQ(Error(ErrorCode::disk_full, "").kind(), ErrorKind::io);
    for (const ErrorRow& row : error_rows()) EXPECT_EQ(row_of(general_code(row.kind)).kind, row.kind);
}

TEST(ErrorCodes, TellErrorsOfTheSystemApart) {
    EXPECT_EQ(code_of_system_error(ENOENT), ErrorCode::file_not_found);
    EXPECT_EQ(code_of_system_error(EDQUOT), ErrorCode::disk_full);
    EXPECT_EQ(code_of_system_error(EIO), ErrorCode::io);
}

TEST(OutOfMemory, IsTheSameFromEachLibrary) {
    EXPECT_TRUE(is_out_of_memory(std::bad_alloc()));
    EXPECT_TRUE(is_out_of_memory(cv::Exception(cv::Error::StsNoMem, "no memory", "fastMalloc", "alloc.cpp", 73)));
    EXPECT_FALSE(is_out_of_memory(cv::Exception(cv::Error::StsBadArg, "wrong", "resize", "resize.cpp", 1)));
    EXPECT_FALSE(is_out_of_memory(std::logic_error("wrong")));
    EXPECT_TRUE(is_out_of_memory(std::runtime_error("pthread_create has failed: Resource temporarily unavailable")));
    EXPECT_FALSE(is_out_of_memory(std::runtime_error("a library's own error")));
}

}  // namespace
}  // namespace vvr
