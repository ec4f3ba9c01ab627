#pragma once

#include <exception>
#include <string>

#include <vvr/failure.h>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr {

constexpr FailureKind failure_kind(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return FailureKind::usage;
        case ErrorKind::io:
            return FailureKind::io;
        case ErrorKind::not_video:
            return FailureKind::not_video;
        case ErrorKind::backend:
            return FailureKind::backend;
        case ErrorKind::limit:
            return FailureKind::limit;
        case ErrorKind::bug:
        case ErrorKind::partial:
        case ErrorKind::differs:
            break;  // only for commands that the library does not have
    }
    return FailureKind::bug;
}

/// Calls `action` and turns any exception into a Failure.
template <class Action>
auto as_failure(const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        throw Failure(failure_kind(error.kind()), row_of(error.code()).name, error.what());
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) {
            throw Failure(FailureKind::limit, row_of(ErrorCode::out_of_memory).name,
                          "out of memory; try a smaller field-size, size or window");
        }
        throw Failure(FailureKind::bug, row_of(ErrorCode::bug).name,
                      std::string("this is a bug in vvr, please report it: ") + error.what());
    }
}

}  // namespace vvr
