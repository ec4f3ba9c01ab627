#include "core/footage/creation_time.h"

#include <array>
#include <fstream>
#include <istream>
#include <string_view>

namespace vvr::footage {

namespace {

std::uint64_t read_big_endian(std::istream& file, int bytes) {
    std::uint64_t number = 0;
    for (int i = 0; i < bytes; ++i) number = number << 8 | static_cast<unsigned char>(file.get());
    return number;
}

/// Goes to the content of the next box of this type.
/// \returns whether there is one
bool enter_box(std::istream& file, std::string_view type) {
    constexpr int most = 1000;
    constexpr std::uint64_t largest = std::uint64_t{1} << 60;
    for (int boxes = 0; boxes < most; ++boxes) {
        const std::istream::pos_type begin = file.tellg();
        std::uint64_t size = read_big_endian(file, 4);
        std::array<char, 4> name{};
        file.read(name.data(), name.size());
        if (size == 1) size = read_big_endian(file, 8);
        if (!file || size < name.size() || size > largest) return false;
        if (std::string_view(name.data(), name.size()) == type) return true;
        file.seekg(begin + static_cast<std::streamoff>(size));
    }
    return false;
}

}  // namespace

std::optional<std::int64_t> creation_time_of(const std::filesystem::path& path) {
    constexpr std::int64_t since_1904 = 2'082'844'800;
    std::ifstream file(path, std::ios::binary);
    if (!enter_box(file, "moov") || !enter_box(file, "mvhd")) return std::nullopt;
    const std::uint64_t version = read_big_endian(file, 4) >> 24;
    const auto time = static_cast<std::int64_t>(read_big_endian(file, version == 1 ? 8 : 4));
    if (!file || time <= 0) return std::nullopt;
    return time >= since_1904 ? time - since_1904 : time;  // some cameras count from 1970
}

}  // namespace vvr::footage
