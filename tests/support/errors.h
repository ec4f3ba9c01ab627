#pragma once

#include <string>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace vvr::test {

/// What is said by the error that a call throws, which is to be of that kind; "no error" when it throws none.
template <class Call>
std::string error_text(ErrorKind kind, const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind);
        return error.what();
    }
    return "no error";
}

}  // namespace vvr::test
