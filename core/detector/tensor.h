#pragma once

#include <string_view>

namespace vvr::detector {

/// Checks that a tensor of an ONNX model has as many numbers as its shape says: OpenCV reads as many as the shape says.
/// \param tensor a message of the type TensorProto
/// \returns its name
/// \throws Error not_a_model with the reason; std::invalid_argument if it is no message
std::string_view check_tensor(std::string_view tensor);

}  // namespace vvr::detector
