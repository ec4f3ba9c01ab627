#include "core/detector/model_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include <onnx/onnx_pb.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/text.h"

namespace vvr::detector {

namespace {

// Sides of a model's input. Three grids divide it, the coarsest into cells of 32 pixels.
constexpr std::int64_t grid = 32;
constexpr std::int64_t longest_side = 2048;

[[noreturn]] void refuse_model(const std::string& what) {
    throw Error(ErrorCode::not_a_model, what);
}

/// Bytes of a raw number of a type, or 0 if OpenCV doesn't read the type.
std::size_t bytes_of_number(std::int32_t type) {
    switch (type) {
        case onnx::TensorProto::FLOAT:
        case onnx::TensorProto::INT32:
            return 4;
        case onnx::TensorProto::UINT8:
        case onnx::TensorProto::INT8:
        case onnx::TensorProto::BOOL:
            return 1;
        case onnx::TensorProto::INT64:
        case onnx::TensorProto::DOUBLE:
            return 8;
        default:
            return 0;
    }
}

/// The numbers of a tensor that are in the list for its type.
std::int64_t listed_numbers(const onnx::TensorProto& tensor) {
    switch (tensor.data_type()) {
        case onnx::TensorProto::FLOAT:
            return tensor.float_data_size();
        case onnx::TensorProto::INT64:
            return tensor.int64_data_size();
        case onnx::TensorProto::DOUBLE:
            return tensor.double_data_size();
        default:
            return tensor.int32_data_size();
    }
}

/// The product of a tensor's sides, or -1 if it is larger than any file.
std::int64_t elements_of(const onnx::TensorProto& tensor) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    std::int64_t elements = 1;
    for (const std::int64_t side : tensor.dims()) {
        if (side < 0 || side > most) return -1;
        elements *= side;
        if (elements > most) return -1;
    }
    return elements;
}

void check_tensor(const onnx::TensorProto& tensor) {
    if (tensor.data_location() == onnx::TensorProto::EXTERNAL || tensor.external_data_size() > 0) {
        refuse_model("its weights are in another file; export it as one file");
    }
    const std::size_t bytes = bytes_of_number(tensor.data_type());
    if (bytes == 0) {
        refuse_model(fmt::format("its weights are of type {}, which OpenCV does not read; export it with 32-bit floats",
                                 tensor.data_type()));
    }
    const std::int64_t elements = elements_of(tensor);
    const std::size_t raw = tensor.raw_data().size();
    const std::int64_t listed = listed_numbers(tensor);  // OpenCV prefers the list
    const bool as_many =
        listed > 0 ? listed == elements : elements >= 0 && raw == bytes * static_cast<std::size_t>(elements);
    if (!as_many) {
        refuse_model(
            fmt::format("it is damaged: the shape of '{}' does not match its numbers", shown_text(tensor.name())));
    }
}

void check_attributes(const onnx::NodeProto& node) {
    for (const onnx::AttributeProto& attribute : node.attribute()) {
        if (attribute.has_g() || attribute.graphs_size() > 0) {
            refuse_model("it has loops or conditions, which no detector needs");
        }
        if (attribute.has_t()) check_tensor(attribute.t());
        for (const onnx::TensorProto& tensor : attribute.tensors()) check_tensor(tensor);
    }
}

Size size_of_input(const onnx::ValueInfoProto& input) {
    std::vector<std::int64_t> sides;  // one that isn't fixed is 0
    for (const auto& side : input.type().tensor_type().shape().dim()) sides.push_back(side.dim_value());
    const bool images = sides.size() == 4 && (sides[0] == 0 || sides[0] == 1) && sides[1] == 3;
    if (!images) {
        refuse_model(fmt::format("its input has the shape [{}], but one colour image has [1, 3, height, width]",
                                 fmt::join(sides, ", ")));
    }
    const auto fits = [](std::int64_t side) { return side > 0 && side <= longest_side && side % grid == 0; };
    if (!fits(sides[2]) || !fits(sides[3])) {
        refuse_model(
            fmt::format("its images have {}x{} pixels; export it for a fixed size of multiples of {}, at most {}",
                        sides[3], sides[2], grid, longest_side));
    }
    return {static_cast<int>(sides[3]), static_cast<int>(sides[2])};
}

}  // namespace

Size check_model(const std::string& bytes) {
    onnx::ModelProto model;
    if (!model.ParseFromString(bytes) || !model.has_graph()) refuse_model("it is not an ONNX file, or a damaged one");
    const onnx::GraphProto& graph = model.graph();
    if (graph.sparse_initializer_size() > 0) refuse_model("it has sparse weights, which OpenCV does not read");
    std::set<std::string_view> weights;
    for (const onnx::TensorProto& tensor : graph.initializer()) {
        check_tensor(tensor);
        weights.insert(tensor.name());
    }
    for (const onnx::NodeProto& node : graph.node()) check_attributes(node);
    // Old versions list the weights as inputs too.
    std::vector<const onnx::ValueInfoProto*> inputs;
    for (const onnx::ValueInfoProto& input : graph.input()) {
        if (!weights.contains(input.name())) inputs.push_back(&input);
    }
    if (inputs.size() != 1) refuse_model(fmt::format("it has {} inputs, not one image", inputs.size()));
    return size_of_input(*inputs.front());
}

}  // namespace vvr::detector
