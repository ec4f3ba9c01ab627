// Neural networks in ONNX format, before OpenCV reads them.
#include "core/detector/onnx.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const auto input = fuzz::parsed([&] { return detector::check_model(fuzz::text_of(data, size)); });
    if (input) fuzz::require(input->width % 32 == 0 && input->height % 32 == 0, "cells divide the image");
    return 0;
}
