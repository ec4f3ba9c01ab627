#pragma once

#include <initializer_list>
#include <string_view>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace vvr::test {

/// Expects an error with this code from a call, and these facts in its text: names, values and places. Its words may
/// change. The place of the call is the default arguments': clang-tidy's clang has no std::source_location yet.
template <class Call>
void expect_error(ErrorCode code, const Call& call, std::initializer_list<std::string_view> facts = {},
                  const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const testing::ScopedTrace trace(file, line, "the error expected here");
    try {
        call();
    } catch (const Error& error) {
        const std::string_view text = error.what();
        EXPECT_STREQ(row_of(error.code()).name, row_of(code).name) << text;
        for (const std::string_view fact : facts) {
            EXPECT_NE(text.find(fact), std::string_view::npos) << text << "\nlacks " << fact;
        }
        return;
    }
    ADD_FAILURE() << "no error";
}

}  // namespace vvr::test
