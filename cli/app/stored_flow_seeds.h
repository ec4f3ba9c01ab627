#pragma once

#include <filesystem>

#include "cli/app/observer.h"
#include "core/fields/options.h"

namespace vvr::app {

/// A stored flow, and the folder for its seed lists.
struct StoredFlowSeedsJob {
    std::filesystem::path flow;  ///< an extraction, or a folder of .flo files whose names end in frame numbers
    std::filesystem::path folder;
    fields::SeedOptions seeds;
};

/// Chooses seeds on a stored flow (the filter stage of §4.2, between the boxes of Fig. 3). Writes one list per frame
/// that has a flow, with its u and v. The folder must be new or empty.
/// \throws Error usage for options that need data which is not stored; io
void write_seeds(const StoredFlowSeedsJob& job, Observer& observer);

}  // namespace vvr::app
