// Neural networks in ONNX format, before OpenCV reads them.
#include "core/detector/model_file.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const auto size = parsed([&] { return detector::check_model(std::string(input)); });
    if (size) require(size->width % 32 == 0 && size->height % 32 == 0, "cells divide the image");
}
