// What libFuzzer calls.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    vvr::fuzz::check({reinterpret_cast<const char*>(data), size});
    return 0;
}
