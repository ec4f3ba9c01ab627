#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields/field.h"

namespace vvr::fields {

/// The seeds of one frame as they stand in a text file (§4.2: S_1, S_2, ...). The format is in docs/formats.md.
struct SeedList {
    std::int64_t frame = 0;  ///< index of the frame in the clip
    Size size;               ///< of the field
    std::vector<Seed> seeds;

    friend bool operator==(const SeedList&, const SeedList&) = default;
};

/// The file's text. Numbers have as many digits as it takes to read the same ones back.
std::string format_seeds(const SeedList& list);

/// \param name of the file, for the error text
/// \throws Error io with name and line for anything that isn't a seed list, for numbers that aren't finite, and for
///         points outside the field
SeedList parse_seeds(std::string_view text, const std::string& name);

/// \throws Error io as above, or when the file can't be read
SeedList read_seeds(const std::string& path);

}  // namespace vvr::fields
