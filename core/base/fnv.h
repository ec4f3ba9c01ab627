#pragma once

#include <cstdint>
#include <string_view>

namespace vvr {

/// FNV-1a of 64 bits: the same number for the same bytes on every machine and in every version, to share out work and
/// to make short names. It keeps no secrets.
constexpr std::uint64_t fnv1a(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3;
    }
    return hash;
}

}  // namespace vvr
