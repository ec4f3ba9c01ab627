// Flow in Middlebury's format.
#include "core/fields/flo_file.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string_view bytes = fuzz::text_of(data, size);
    const auto flow = fuzz::parsed([&] { return fields::decode_flo(bytes, "x.flo"); });
    if (flow) fuzz::require(fields::encode_flo(*flow) == bytes, "flow is written as it was read");
    return 0;
}
