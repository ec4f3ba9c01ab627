#include <vvr/failure.h>

namespace vvr {

Failure::Failure(FailureKind kind, const char* code, const std::string& text)
    : std::runtime_error(text), kind_(kind), code_(code) {}

// Here, so that the class has one type for this library and for all who catch it.
Failure::~Failure() = default;

}  // namespace vvr
