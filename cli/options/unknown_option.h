#pragma once

#include <span>
#include <string>

#include "core/base/error.h"

namespace vvr::options {

/// The error for an option that there is not. It says what to use instead: the equivalent of another program's option,
/// or the nearest name.
/// \param name with its dashes
/// \param known the options that there are, with their dashes
/// \param command as it is typed: "vvr render"
Error unknown_option(const std::string& name, std::span<const std::string> known, const std::string& command);

}  // namespace vvr::options
