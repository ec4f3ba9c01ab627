#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/plane.h"

namespace vvr::detector {

/// \throws Error not_a_model, always
[[noreturn]] void refuse_model(const std::string& what);

/// How the value of a field is encoded.
enum class Wire { varint = 0, fixed64 = 1, bytes = 2, fixed32 = 5 };

/// A field of a message in the wire format of Protocol Buffers.
struct ProtobufField {
    std::uint64_t number = 0;
    Wire wire = Wire::varint;
    std::uint64_t value = 0;  ///< of a varint
    std::string_view bytes;   ///< of any other: a text, a message, a packed list, or a number's 4 or 8 bytes
};

/// Reads the fields of a message in their order.
class ProtobufReader {
  public:
    explicit ProtobufReader(std::string_view message) : left_(message) {}

    /// The next field; nothing at the end.
    /// \throws std::invalid_argument if the bytes are no message
    std::optional<ProtobufField> next();

    /// The next number of a packed list of varints; nothing at the end.
    std::optional<std::uint64_t> next_packed();

  private:
    std::uint64_t read_varint();
    std::string_view read_bytes(std::uint64_t count);

    std::string_view left_;
};

/// Keeps the bytes of a field that a message can have once. Protocol Buffers would merge a second one into the first.
/// \throws std::invalid_argument if there was one before
void set_once(std::optional<std::string_view>& known, const ProtobufField& field);

/// Checks that a tensor of an ONNX model has as many numbers as its shape says: OpenCV reads as many as the shape says.
/// \param tensor a message of the type TensorProto
/// \returns its name
/// \throws Error not_a_model with the reason; std::invalid_argument if it is no message
std::string_view check_tensor(std::string_view tensor);

/// Checks a model in ONNX format before OpenCV reads it. OpenCV believes what a file says of its own sizes, and reads
/// beyond the end of weights that are shorter than their shape. It also counts on the inputs of each operator.
/// \param bytes the file
/// \returns the size of the images that the model takes
/// \throws Error not_a_model with the reason, "it is ...", without the name of the file
Size check_model(std::string_view bytes);

}  // namespace vvr::detector
