#pragma once

#include <cstdint>
#include <string_view>

namespace vvr::archive {

/// A stable share of the clips: those whose path's FNV-1a hash, 64 bits, leaves `index` when divided by `count`.
struct Shard {
    std::uint64_t index = 0;  ///< from 0
    std::uint64_t count = 1;

    bool contains(std::string_view clip) const;
};

}  // namespace vvr::archive
