#pragma once

#include "cli/render/job.h"
#include "cli/render/observer.h"
#include "cli/render/report.h"

/// The application as a library: a job in; pictures, a page, a report and the comparison with a golden picture out.
namespace vvr {

/// Does a whole job: frames → fields → bricks → pictures → files.
/// \throws Error of every kind; `differs` after everything has been written
RenderReport render(const RenderJob& job, Observer& observer);

}  // namespace vvr
