#pragma once

#include <filesystem>
#include <string>

#include "cli/workers/worker.h"
#include "core/base/error.h"

// What the end of a worker means for its clip.
namespace vvr::workers {

/// Whether the clip has no picture.
bool failed(const WorkerResult& end);

/// Drawn, but some of its files are missing.
bool is_not_whole(const WorkerResult& end);

/// Whether the worker reports an OpenGL error. The clip need not be the cause: see start_drawing_test.
bool opengl_failed(const WorkerResult& end);

/// The worker's error text for people; if it sent none, the end of its stderr.
std::string error_text_of(const WorkerResult& end);

/// Why it failed, in a sentence.
std::string reason_of(const WorkerResult& end, const WorkerLimits& limits);

/// The exit status for a failed clip's sidecar. We choose it if we killed the worker, or if the worker ended normally
/// but its report is invalid.
int status_of(const WorkerResult& end);

/// The error code for the sidecar. The worker's own code is used only if it agrees with the exit status.
ErrorCode code_of(const WorkerResult& end);

/// Throws if the system, not the clip, is at fault. Decides only by what the parent has observed: a worker's report is
/// untrusted.
/// \throws Error worker_start_failed, or io for a full disk
void throw_if_system_fault(const std::string& clip, const std::filesystem::path& folder, const WorkerResult& end);

}  // namespace vvr::workers
