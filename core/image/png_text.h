#pragma once

#include <cstddef>
#include <vector>

namespace vvr::image {

/// A PNG file whose texts beyond ASCII are marked as UTF-8: they become chunks iTXt. Readers take the chunks tEXt, all
/// that OpenImageIO writes, for Latin-1.
std::vector<std::byte> with_utf8_texts(const std::vector<std::byte>& png);

}  // namespace vvr::image
