#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/footage/recorder_names.h"
#include "core/media/frame_source.h"

namespace vvr::footage {

/// Opens a video: a file, a URL, `-` for a stream on stdin, or a sequence of pictures given as a folder, a glob
/// (`dir/*.png`) or a printf pattern (`dir/%05d.png`). Decodes the first frame, so a source that opens has one.
///
/// A pipe is first spooled to an unlinked temporary file in $TMPDIR or /var/tmp, because it is read more than once.
///
/// \throws Error io if it can't be read or spooled, not_video if no frame decodes, limit if its pictures are too large,
///         usage if `options` don't fit the clip
std::unique_ptr<media::FrameSource> open_source(const std::string& name, const media::SourceOptions& options = {});

/// Opens one or more inputs: a recording of several files (see `find_recording`), or a single input.
/// \param schemes the naming schemes of file names
/// \param warnings receives one sentence per warning
/// \throws Error as `open_source` and `find_recording`
std::unique_ptr<media::FrameSource> open_sources(const std::vector<std::string>& names,
                                                 const media::SourceOptions& options, const RecorderNames& schemes,
                                                 std::vector<std::string>& warnings);

}  // namespace vvr::footage
