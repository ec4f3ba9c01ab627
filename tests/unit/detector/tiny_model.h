#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vvr::test {

/// A message in the wire format of Protocol Buffers, written field by field.
class ProtobufWriter {
  public:
    ProtobufWriter& number(std::uint64_t field, std::uint64_t value);
    ProtobufWriter& bytes(std::uint64_t field, std::string_view value);
    ProtobufWriter& real(std::uint64_t field, float value);

    const std::string& text() const { return text_; }

  private:
    void varint(std::uint64_t value);

    std::string text_;
};

/// A model whose answer is known. It looks at one pixel of each cell of the finest grid, the upper left one. The first
/// channel of that pixel divided by `full` is the probability that there is an object, which is certainly of `class_id`
/// then. The coarser grids have nothing.
struct TinyModel {
    int side = 64;                                               ///< of the input
    int numbers = 85;                                            ///< of a row
    int class_id = 0;                                            ///< of all objects
    std::vector<float> box{0.5F, 0.5F, 0.6931472F, 0.6931472F};  ///< of all rows: by YOLOX, two cells wide and high
    float full = 255;                                            ///< input value of a certain object
    int copies = 1;                                              ///< of the rows of each grid
    bool transposed = false;                                     ///< the output has one column per box
    std::string last_node{};                                     ///< an operator after all others; empty = none

    /// The model in ONNX format.
    std::string onnx() const;
};

}  // namespace vvr::test
