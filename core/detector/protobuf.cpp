#include "core/detector/protobuf.h"

#include <stdexcept>

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
    throw std::invalid_argument("a field is of no known type");
}

std::optional<std::uint64_t> ProtobufReader::next_packed() {
    if (left_.empty()) return std::nullopt;
    return read_varint();
}

void set_once(std::optional<std::string_view>& known, const ProtobufField& field) {
    if (known) throw std::invalid_argument("a part is there twice");
    known = field.bytes;
}

}  // namespace vvr::detector
