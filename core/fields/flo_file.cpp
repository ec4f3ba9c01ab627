#include "core/fields/flo_file.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"

namespace vvr::fields {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

constexpr float magic = 202021.25F;  // its bytes are "PIEH"
constexpr std::size_t header_bytes = 12;
constexpr std::int32_t largest_side = 65536;

template <class T>
T at(std::string_view bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

[[noreturn]] void fail(const std::string& name, const std::string& what) {
    throw Error(ErrorCode::file_invalid,
                fmt::format("{}: not a flow file: {}; docs/formats.md describes the format", name, what));
}

}  // namespace

std::string encode_flo(const Flow& flow) {
    std::string bytes;
    bytes.reserve(header_bytes + flow.u.pixels().size_bytes() * 2);
    append(bytes, magic);
    append(bytes, static_cast<std::int32_t>(flow.u.width()));
    append(bytes, static_cast<std::int32_t>(flow.u.height()));
    for (std::size_t i = 0; i < flow.u.pixels().size(); ++i) {
        append(bytes, flow.u.pixels()[i]);
        append(bytes, flow.v.pixels()[i]);
    }
    return bytes;
}

Flow decode_flo(std::string_view bytes, const std::string& name) {
    if (bytes.size() < header_bytes)
        fail(name, fmt::format("it has {} bytes, fewer than the 12 of a header", bytes.size()));
    if (at<float>(bytes, 0) != magic) fail(name, "it doesn't begin with the number 202021.25 (\"PIEH\")");
    const Size size{at<std::int32_t>(bytes, 4), at<std::int32_t>(bytes, 8)};
    if (size.width < 1 || size.height < 1 || size.width > largest_side || size.height > largest_side) {
        fail(name, fmt::format("its header gives {}x{} pixels, but a side has 1 to {}", size.width, size.height,
                               largest_side));
    }
    const std::size_t expected =
        header_bytes + static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 8;
    if (bytes.size() != expected) {
        fail(name, fmt::format("it has {} bytes, but a flow of {}x{} needs {}", bytes.size(), size.width, size.height,
                               expected));
    }
    Flow flow{Plane<float>(size), Plane<float>(size)};
    for (std::size_t i = 0; i < flow.u.pixels().size(); ++i) {
        const auto u = at<float>(bytes, header_bytes + 8 * i);
        const auto v = at<float>(bytes, header_bytes + 8 * i + 4);
        if (std::isnan(u) || std::isnan(v)) fail(name, fmt::format("vector {} is not a number", i));
        flow.u.pixels()[i] = u;
        flow.v.pixels()[i] = v;
    }
    return flow;
}

Flow read_flo(const std::string& path) {
    return decode_flo(read_file(path), path);
}

}  // namespace vvr::fields
