// Flow in Middlebury's format.
#include "core/fields/flo_file.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view bytes) {
    const auto flow = parsed([&] { return fields::decode_flo(bytes, "x.flo"); });
    if (flow) require(fields::encode_flo(*flow) == bytes, "flow is written as it was read");
}
