#pragma once

#include <string>

namespace vvr {

/// What a picture and a page call their clip: an input's name without its folders, which are nobody's business. Of an
/// address neither who may see it is told, nor by what word.
std::string shown_name(const std::string& input);

}  // namespace vvr
