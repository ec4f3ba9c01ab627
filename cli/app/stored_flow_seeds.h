#pragma once

#include <filesystem>

#include "cli/app/observer.h"
#include "core/fields/options.h"

namespace vvr::app {

/// A stored flow, and the folder that the lists of its seeds go to.
struct StoredFlowSeedsJob {
    std::filesystem::path flow;  ///< an extraction, or a folder of .flo files whose names end in their frames' numbers
    std::filesystem::path folder;
    fields::SeedOptions seeds;
};

/// Chooses seeds on a flow that is stored (§4.2's filter stage by itself, between the boxes of Fig. 3): one list for
/// each frame that has a flow, with u and v of that flow. Without an error the folder is new, or was empty.
/// \throws Error usage for options that need more than there is, io
void write_seeds(const StoredFlowSeedsJob& job, Observer& observer);

}  // namespace vvr::app
