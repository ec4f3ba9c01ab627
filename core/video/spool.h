#pragma once

#include <memory>
#include <string>

#include "core/video/input.h"

namespace vvr::video {

/// Copies everything that `from` gives to an unlinked temporary file in $TMPDIR, or /var/tmp: the file vanishes with
/// its last descriptor, however the program ends.
///
/// \param name of the stream, for messages
/// \throws Error io when reading or writing fails, a full disk among them
std::shared_ptr<const Descriptor> spool(const Descriptor& from, const std::string& name);

}  // namespace vvr::video
