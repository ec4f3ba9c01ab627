#include "core/base/error.h"

#include <cerrno>
#include <set>
#include <string>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace vvr
