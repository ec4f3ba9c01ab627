#include "core/detector/onnx.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"

namespace vvr::detector {

std::uint64_t ProtobufReader::read_varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        if (left_.empty()) throw std::invalid_argument("a number is cut");
        const auto byte = static_cast<unsigned char>(left_.front());
        left_.remove_prefix(1);
        value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
        if (byte < 0x80) return value;
    }
    throw std::invalid_argument("a number is too long");
}

std::string_view ProtobufReader::read_bytes(std::uint64_t count) {
    if (count > left_.size()) throw std::invalid_argument("a field is cut");
    const std::string_view bytes = left_.substr(0, count);
    left_.remove_prefix(count);
    return bytes;
}

std::optional<ProtobufField> ProtobufReader::next() {
    if (left_.empty()) return std::nullopt;
    const std::uint64_t key = read_varint();
    ProtobufField field{.number = key >> 3U, .wire = static_cast<Wire>(key & 7U), .value = 0, .bytes = {}};
    if (field.number == 0) throw std::invalid_argument("a field has no number");
    switch (field.wire) {
        case Wire::varint:
            field.value = read_varint();
            return field;
        case Wire::fixed64:
            field.bytes = read_bytes(8);
            return field;
        case Wire::bytes:
            field.bytes = read_bytes(read_varint());
            return field;
        case Wire::fixed32:
            field.bytes = read_bytes(4);
            return field;
    }
    throw std::invalid_argument("a field has an unknown type");
}

std::optional<std::uint64_t> ProtobufReader::next_packed() {
    if (left_.empty()) return std::nullopt;
    return read_varint();
}

void set_once(std::optional<std::string_view>& known, const ProtobufField& field) {
    if (known) throw std::invalid_argument("a part occurs twice");
    known = field.bytes;
}

namespace {

// Numbers of fields, from the schema onnx.proto.
namespace tensor_field {
constexpr std::uint64_t dimension = 1;
constexpr std::uint64_t type = 2;
constexpr std::uint64_t name = 8;
constexpr std::uint64_t raw = 9;
constexpr std::uint64_t external = 13;
}  // namespace tensor_field

/// A type of a tensor's numbers.
struct NumberType {
    std::uint64_t number;  ///< in the schema
    std::size_t bytes;     ///< of a raw number
    std::uint64_t list;    ///< the field that has the numbers if they aren't raw
};

constexpr std::array number_types{
    NumberType{1, 4, 4},   // float: float_data
    NumberType{2, 1, 5},   // uint8: int32_data
    NumberType{3, 1, 5},   // int8: int32_data
    NumberType{6, 4, 5},   // int32: int32_data
    NumberType{7, 8, 7},   // int64: int64_data
    NumberType{9, 1, 5},   // bool: int32_data
    NumberType{11, 8, 10}  // double: double_data
};

constexpr std::array<std::uint64_t, 6> data_fields{4, 5, 6, 7, 10, 11};  // the lists of any type

std::uint64_t count_of_varints(const ProtobufField& field) {
    if (field.wire == Wire::varint) return 1;
    // The last byte of each is below 0x80.
    return static_cast<std::uint64_t>(
        std::ranges::count_if(field.bytes, [](char byte) { return static_cast<unsigned char>(byte) < 0x80; }));
}

/// The numbers that a field adds to a list.
std::uint64_t count_of_numbers(const ProtobufField& field) {
    if (field.number == 4) return field.bytes.size() / sizeof(float);
    if (field.number == 10) return field.bytes.size() / sizeof(double);
    return count_of_varints(field);
}

/// The product of dimensions; nothing if it is larger than any file.
std::optional<std::uint64_t> product(const std::vector<std::uint64_t>& dimensions) {
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    std::uint64_t elements = 1;
    for (const std::uint64_t side : dimensions) {
        if (side > most) return std::nullopt;
        elements *= side;
        if (elements > most) return std::nullopt;
    }
    return elements;
}

/// Adds the numbers of a field that may be packed.
void append_varints(const ProtobufField& field, std::vector<std::uint64_t>& numbers) {
    if (field.wire == Wire::varint) numbers.push_back(field.value);
    if (field.wire != Wire::bytes) return;
    ProtobufReader packed(field.bytes);
    while (const auto number = packed.next_packed()) numbers.push_back(*number);
}

}  // namespace

void refuse_model(const std::string& what) {
    throw Error(ErrorCode::not_a_model, what);
}

std::string_view check_tensor(std::string_view tensor) {
    std::vector<std::uint64_t> dimensions;
    std::uint64_t type = 0;
    std::string_view name;
    std::optional<std::string_view> raw;
    std::array<std::uint64_t, data_fields.size()> listed{};
    ProtobufReader reader(tensor);
    while (const auto field = reader.next()) {
        if (field->number == tensor_field::dimension) append_varints(*field, dimensions);
        if (field->number == tensor_field::type) type = field->value;
        if (field->number == tensor_field::name) name = field->bytes;
        if (field->number == tensor_field::raw) set_once(raw, *field);
        if (field->number == tensor_field::external)
            refuse_model("its weights are in another file; export it as one file");
        const auto* const list = std::ranges::find(data_fields, field->number);
        if (list != data_fields.end()) {
            listed.at(static_cast<std::size_t>(list - data_fields.begin())) += count_of_numbers(*field);
        }
    }
    const auto* const known = std::ranges::find(number_types, type, &NumberType::number);
    if (known == number_types.end()) {
        refuse_model(
            fmt::format("its weights are of type {}, which OpenCV does not read; export it with 32-bit floats", type));
    }
    const auto elements = product(dimensions);
    const std::uint64_t in_raw = raw ? raw->size() / known->bytes : 0;
    std::uint64_t all = in_raw;
    for (const std::uint64_t count : listed) all += count;
    const auto own = static_cast<std::size_t>(std::ranges::find(data_fields, known->list) - data_fields.begin());
    const std::uint64_t in_list = listed.at(own);
    const bool whole = !raw || raw->size() % known->bytes == 0;
    const bool in_one_place = all == in_raw || (all == in_list && !raw);
    if (!elements || !whole || !in_one_place || all != *elements) {
        refuse_model(fmt::format("it is damaged: the shape of '{}' does not match its numbers", shown_text(name)));
    }
    return name;
}

}  // namespace vvr::detector
