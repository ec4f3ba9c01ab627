#include "tests/unit/detector/tiny_model.h"

#include <cstddef>
#include <cstring>

#include <fmt/format.h>

namespace vvr::test {

void ProtobufWriter::varint(std::uint64_t value) {
    while (value >= 0x80) {
        text_.push_back(static_cast<char>(value | 0x80U));
        value >>= 7U;
    }
    text_.push_back(static_cast<char>(value));
}

ProtobufWriter& ProtobufWriter::number(std::uint64_t field, std::uint64_t value) {
    varint(field << 3U);
    varint(value);
    return *this;
}

ProtobufWriter& ProtobufWriter::bytes(std::uint64_t field, std::string_view value) {
    varint(field << 3U | 2U);
    varint(value.size());
    text_ += value;
    return *this;
}

ProtobufWriter& ProtobufWriter::real(std::uint64_t field, float value) {
    varint(field << 3U | 5U);
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
}

namespace {

constexpr std::uint64_t floats = 1;
constexpr std::uint64_t integers = 7;

template <class T>
std::string tensor(std::string_view name, std::uint64_t type, const std::vector<int>& shape,
                   const std::vector<T>& values) {
    ProtobufWriter writer;
    for (const int side : shape) writer.number(1, static_cast<std::uint64_t>(side));
    writer.number(2, type).bytes(8, name);
    writer.bytes(9, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    return writer.text();
}

std::string attribute(std::string_view name, std::uint64_t value) {
    constexpr std::uint64_t integer = 2;
    return ProtobufWriter().bytes(1, name).number(3, value).number(20, integer).text();
}

std::string attribute(std::string_view name, const std::vector<int>& values) {
    constexpr std::uint64_t list_of_integers = 7;
    ProtobufWriter writer;
    writer.bytes(1, name);
    for (const int value : values) writer.number(8, static_cast<std::uint64_t>(value));
    return writer.number(20, list_of_integers).text();
}

std::string node(std::string_view operation, const std::vector<std::string>& inputs, std::string_view output,
                 const std::vector<std::string>& attributes) {
    ProtobufWriter writer;
    for (const std::string& input : inputs) writer.bytes(1, input);
    writer.bytes(2, output).bytes(3, output).bytes(4, operation);
    for (const std::string& attribute : attributes) writer.bytes(5, attribute);
    return writer.text();
}

std::string value(std::string_view name, const std::vector<int>& shape) {
    ProtobufWriter dimensions;
    for (const int side : shape) {
        dimensions.bytes(1, ProtobufWriter().number(1, static_cast<std::uint64_t>(side)).text());
    }
    const std::string type = ProtobufWriter().number(1, floats).bytes(2, dimensions.text()).text();
    return ProtobufWriter().bytes(1, name).bytes(2, ProtobufWriter().bytes(1, type).text()).text();
}

}  // namespace

std::string TinyModel::onnx() const {
    ProtobufWriter graph;
    const auto count = static_cast<std::size_t>(numbers);
    std::vector<float> constants(count);
    std::memcpy(constants.data(), box.data(), box.size() * sizeof(float));
    constants.at(5 + static_cast<std::size_t>(class_id)) = 1;
    graph.bytes(5, tensor("constants", floats, {numbers}, constants));
    std::vector<std::string> grids;
    int cells = 0;
    for (const int stride : {8, 16, 32}) {
        std::vector<float> weights(count * 3);
        if (stride == 8) weights.at(4 * 3) = 1 / full;
        const int columns = side / stride;
        const std::string name = fmt::format("grid{}", stride);
        graph.bytes(5, tensor(name + ".weights", floats, {numbers, 3, 1, 1}, weights));
        graph.bytes(5,
                    tensor(name + ".shape", integers, {3}, std::vector<std::int64_t>{1, numbers, columns * columns}));
        graph.bytes(1, node("Conv", {"image", name + ".weights", "constants"}, name + ".map",
                            {attribute("kernel_shape", {1, 1}), attribute("strides", {stride, stride})}));
        graph.bytes(1, node("Reshape", {name + ".map", name + ".shape"}, name, {}));
        for (int copy = 0; copy < copies; ++copy) grids.push_back(name);
        cells += columns * columns * copies;
    }
    graph.bytes(1, node("Concat", grids, transposed ? "output" : "all", {attribute("axis", 2)}));
    if (!transposed) graph.bytes(1, node("Transpose", {"all"}, "output", {attribute("perm", {0, 2, 1})}));
    if (!last_node.empty()) graph.bytes(1, last_node);
    graph.bytes(2, "tiny").bytes(11, value("image", {1, 3, side, side}));
    graph.bytes(12, value("output", transposed ? std::vector{1, numbers, cells} : std::vector{1, cells, numbers}));
    constexpr std::uint64_t version = 6;
    constexpr std::uint64_t operators = 11;
    const std::string operator_set = ProtobufWriter().bytes(1, "").number(2, operators).text();
    return ProtobufWriter().number(1, version).bytes(7, graph.text()).bytes(8, operator_set).text();
}

}  // namespace vvr::test
