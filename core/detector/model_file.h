#pragma once

#include <string_view>

#include "core/base/plane.h"

namespace vvr::detector {

/// Checks a model in ONNX format before OpenCV reads it. OpenCV believes what a file says of its own sizes, and reads
/// beyond the end of weights that are shorter than their shape. It also counts on the inputs of each operator.
/// \param bytes the file
/// \returns the size of the images that the model takes
/// \throws Error not_a_model with the reason, "it is ...", without the name of the file
Size check_model(std::string_view bytes);

}  // namespace vvr::detector
