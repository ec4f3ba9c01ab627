#pragma once

#include <string>

#include "core/base/plane.h"

namespace vvr::detector {

/// Reads what OpenCV doesn't tell of a model in ONNX format, and checks what OpenCV doesn't check: it reads as many
/// weights as a tensor's shape says, also beyond the end of the data. The trial of the model finds all else.
/// \param bytes the file
/// \returns the size of the images that the model takes
/// \throws Error not_a_model with the reason, "it is ...", without the name of the file
Size check_model(const std::string& bytes);

}  // namespace vvr::detector
