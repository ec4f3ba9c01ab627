#pragma once

#include <functional>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "cli/app/report.h"

/// The application: a job in; pictures, a page, a report and the comparison with a golden picture out.
namespace vvr::app {

/// Takes each picture of a run, with what its file records.
using DrawnSink = std::function<void(const image::Picture& picture, const image::Metadata& record)>;

/// Does a whole job: frames → fields → bricks → pictures → files.
/// \param taken called for each picture before it goes to its file; there is one even if no file is wanted.
///        Empty = nobody takes them
/// \throws Error of every kind; `differs` after everything has been written
RenderReport render(const RenderJob& job, Observer& observer, const DrawnSink& taken = {});

}  // namespace vvr::app
