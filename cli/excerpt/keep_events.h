#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/excerpt/piece.h"
#include "cli/observe/observe.h"
#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "core/base/error.h"

namespace vvr::app {

/// The pieces of a clip or recording in which its events are.
struct KeptEvents {
    std::vector<WrittenPiece> pieces;  ///< in order of time
    std::string problem{};             ///< which events have no piece, and why; empty = all have one
    std::optional<ErrorCode> code{};   ///< if a file could not be read or written: another try may succeed
};

/// Copies each event, with a margin, to a file in the plan's folder of pieces, and writes the record of that folder.
/// Events that overlap in time share a piece, named after the first of them. An event that can't be copied is left out.
/// \throws Error io for a full disk or if the record can't be written, limit
KeptEvents keep_events(const Plan& plan, const Observation& seen, Observer& observer);

}  // namespace vvr::app
