#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vvr::fields {

/// In which bricks a seed makes geometry (§6): a digit 0 or 1 per brick, from the clip's first brick on; after the last
/// digit they begin again. By default it does in all.
class SeedFlags {
  public:
    static constexpr int most = 32;  ///< digits

    SeedFlags() = default;

    /// Of `1`, `0` or `100`; nothing for what isn't 1 to `most` digits 0 and 1.
    static std::optional<SeedFlags> parse(std::string_view digits);

    bool in(std::int64_t brick) const { return ((digits_ >> static_cast<unsigned>(brick % count_)) & 1U) != 0; }

    std::string text() const;

    friend bool operator==(const SeedFlags&, const SeedFlags&) = default;

  private:
    std::uint32_t digits_ = 1;  ///< the first in the lowest bit
    int count_ = 1;
};

}  // namespace vvr::fields
