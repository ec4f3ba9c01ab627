#pragma once

#include <memory>

#include "cli/plan/plan.h"
#include "cli/plan/settings.h"

namespace vvr::app {

/// The purpose of a run, beyond the files named by its output.
enum class Purpose {
    files,   ///< the files named by its output
    caller,  ///< the caller takes the pictures
    stream,  ///< a live stream; one picture per brick
    search,  ///< only the events
};

/// Makes the plan, for all commands, of a job and the header of the opened clip.
/// \param job valid, see validate()
/// \param detector from open_detector; null = none
/// \throws Error usage for an unknown colour, object colours when the filter marks no objects, flow colours without
/// flow, and bricks or a clock for which the clip lacks data
Plan make_plan(RenderJob job, ClipFacts clip, Purpose purpose = Purpose::files,
               std::shared_ptr<detector::Detector> detector = nullptr);

/// \throws Error limit when the machine has less memory than needed, as the system would otherwise kill the program
/// during the run
void check_memory(const Extent& extent);

}  // namespace vvr::app
