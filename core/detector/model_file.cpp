
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/detector/onnx.h"

namespace vvr::detector {

namespace {

// Numbers of fields, from the schema onnx.proto.
namespace model_field {
constexpr std::uint64_t graph = 7;
}
namespace graph_field {
constexpr std::uint64_t node = 1;
constexpr std::uint64_t initializer = 5;
constexpr std::uint64_t input = 11;
constexpr std::uint64_t sparse_initializer = 15;
}  // namespace graph_field
namespace node_field {
constexpr std::uint64_t input = 1;
constexpr std::uint64_t output = 2;
constexpr std::uint64_t operation = 4;
constexpr std::uint64_t attribute = 5;
}  // namespace node_field
namespace attribute_field {
constexpr std::uint64_t tensor = 5;
constexpr std::uint64_t graph = 6;
constexpr std::uint64_t tensors = 10;
constexpr std::uint64_t graphs = 11;
}  // namespace attribute_field
constexpr std::uint64_t value_name = 1;
constexpr std::array<std::uint64_t, 3> shape_of_value{2, 1, 2};  // type, tensor type, shape
constexpr std::uint64_t shape_dimension = 1;
constexpr std::uint64_t dimension_value = 1;

/// An operator and the number of its inputs.
struct Operator {
    std::string_view name;
    std::size_t least;
    std::size_t most;
};

constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

/// What detectors of formats() are made of.
constexpr std::array operators{
    Operator{"Add", 2, 2},
    Operator{"BatchNormalization", 5, 5},
    Operator{"Cast", 1, 1},
    Operator{"Clip", 1, 3},
    Operator{"Concat", 1, any},
    Operator{"Constant", 0, 0},
    Operator{"ConstantOfShape", 1, 1},
    Operator{"Conv", 2, 3},
    Operator{"Div", 2, 2},
    Operator{"Exp", 1, 1},
    Operator{"Expand", 2, 2},
    Operator{"Gather", 2, 2},
    Operator{"HardSigmoid", 1, 1},
    Operator{"Identity", 1, 1},
    Operator{"LeakyRelu", 1, 1},
    Operator{"MaxPool", 1, 1},
    Operator{"Mul", 2, 2},
    Operator{"Pow", 2, 2},
    Operator{"Relu", 1, 1},
    Operator{"Reshape", 2, 2},
    Operator{"Resize", 2, 4},
    Operator{"Shape", 1, 1},
    Operator{"Sigmoid", 1, 1},
    Operator{"Slice", 1, 5},
    Operator{"Softmax", 1, 1},
    Operator{"Split", 1, 2},
    Operator{"Squeeze", 1, 2},
    Operator{"Sub", 2, 2},
    Operator{"Transpose", 1, 1},
    Operator{"Unsqueeze", 1, 2},
    Operator{"Upsample", 2, 2},
};

// Sides of a model's input. Three grids divide it, the coarsest into cells of 32 pixels.
constexpr std::uint64_t grid = 32;
constexpr std::uint64_t longest_side = 2048;

void check_attribute(std::string_view attribute) {
    std::optional<std::string_view> tensor;
    ProtobufReader reader(attribute);
    while (const auto field = reader.next()) {
        if (field->number == attribute_field::tensor) set_once(tensor, *field);
        if (field->number == attribute_field::tensors) check_tensor(field->bytes);
        if (field->number == attribute_field::graph || field->number == attribute_field::graphs) {
            refuse_model("it has loops or conditions, which no detector needs");
        }
    }
    if (tensor) check_tensor(*tensor);
}

/// Checks an operator, and adds its outputs to the values that are known.
void check_node(std::string_view node, std::set<std::string_view>& known) {
    std::vector<std::string_view> inputs;
    std::vector<std::string_view> outputs;
    std::string_view name;
    ProtobufReader reader(node);
    while (const auto field = reader.next()) {
        if (field->number == node_field::input) inputs.push_back(field->bytes);
        if (field->number == node_field::output) outputs.push_back(field->bytes);
        if (field->number == node_field::operation) name = field->bytes;
        if (field->number == node_field::attribute) check_attribute(field->bytes);
    }
    const auto* const row = std::ranges::find(operators, name, &Operator::name);
    if (row == operators.end()) {
        refuse_model(fmt::format("it needs the operator '{}', which no supported detector uses",
                                 shown_text(name.substr(0, 100))));
    }
    if (inputs.size() < row->least || inputs.size() > row->most) {
        refuse_model(fmt::format("it is damaged: the operator '{}' has {}", name,
                                 counted(static_cast<std::int64_t>(inputs.size()), "input")));
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const bool left_out = inputs[i].empty() && i >= row->least;
        if (left_out || known.contains(inputs[i])) continue;
        refuse_model(fmt::format("it is damaged: no earlier operator produces '{1}', an input of the operator '{0}'",
                                 name, shown_text(inputs[i].substr(0, 100))));
    }
    known.insert(outputs.begin(), outputs.end());
}

/// A value between the operators: its name and its sides; a side that is not fixed is 0.
struct Value {
    std::string_view name;
    std::vector<std::uint64_t> sides;
};

/// The message that a field holds; the last one, as Protocol Buffers have it.
std::string_view message_in(std::string_view message, std::uint64_t number) {
    std::string_view found;
    ProtobufReader reader(message);
    while (const auto field = reader.next()) {
        if (field->number == number) found = field->bytes;
    }
    return found;
}

Value read_value(std::string_view message) {
    Value value{message_in(message, value_name), {}};
    for (const std::uint64_t number : shape_of_value) message = message_in(message, number);
    ProtobufReader shape(message);
    while (const auto dimension = shape.next()) {
        if (dimension->number != shape_dimension) continue;
        std::uint64_t side = 0;
        ProtobufReader reader(dimension->bytes);
        while (const auto field = reader.next()) {
            if (field->number == dimension_value) side = field->value;
        }
        value.sides.push_back(side);
    }
    return value;
}

Size size_of_input(const std::vector<Value>& inputs) {
    if (inputs.size() != 1) refuse_model(fmt::format("it has {} inputs, not one image", inputs.size()));
    const std::vector<std::uint64_t>& sides = inputs.front().sides;
    const bool images = sides.size() == 4 && sides[0] <= 1 && sides[1] == 3;
    if (!images) {
        refuse_model(fmt::format("its input has the shape [{}], but one colour image has [1, 3, height, width]",
                                 fmt::join(sides, ", ")));
    }
    const auto fits = [](std::uint64_t side) { return side > 0 && side <= longest_side && side % grid == 0; };
    if (!fits(sides[2]) || !fits(sides[3])) {
        refuse_model(
            fmt::format("its images have {}x{} pixels; export it for a fixed size of multiples of {}, at most {}",
                        sides[3], sides[2], grid, longest_side));
    }
    return {static_cast<int>(sides[3]), static_cast<int>(sides[2])};
}

Size check_graph(std::string_view graph) {
    std::vector<std::string_view> nodes;
    std::set<std::string_view> known;  // names of values
    std::vector<Value> inputs;
    ProtobufReader reader(graph);
    while (const auto field = reader.next()) {
        if (field->number == graph_field::node) nodes.push_back(field->bytes);
        if (field->number == graph_field::initializer) known.insert(check_tensor(field->bytes));
        if (field->number == graph_field::sparse_initializer) {
            refuse_model("it has sparse weights, which OpenCV does not read");
        }
        if (field->number == graph_field::input) inputs.push_back(read_value(field->bytes));
    }
    // Old versions list the weights as inputs too.
    std::erase_if(inputs, [&](const Value& value) { return known.contains(value.name); });
    const Size size = size_of_input(inputs);
    known.insert(inputs.front().name);
    for (const std::string_view node : nodes) check_node(node, known);
    return size;
}

}  // namespace

Size check_model(std::string_view bytes) {
    if (bytes.empty()) refuse_model("it is empty");
    try {
        std::optional<std::string_view> graph;
        ProtobufReader reader(bytes);
        while (const auto field = reader.next()) {
            if (field->number == model_field::graph) set_once(graph, *field);
        }
        if (!graph) refuse_model("it is not an ONNX file");
        return check_graph(*graph);
    } catch (const std::invalid_argument& error) {
        refuse_model(fmt::format("it is not an ONNX file, or a damaged one: {}", error.what()));
    }
}

}  // namespace vvr::detector
