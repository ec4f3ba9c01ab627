#include <vvr/failure.h>

namespace vvr {

Failure::Failure(FailureKind kind, const char* code, const std::string& text)
    : std::runtime_error(text), kind_(kind), code_(code) {}

// Defined here, so that the library and its callers share one type for catch.
Failure::~Failure() = default;

}  // namespace vvr
