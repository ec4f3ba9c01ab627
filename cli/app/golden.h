#pragma once

#include <filesystem>

#include "cli/app/observer.h"
#include "cli/app/output.h"
#include "core/image/picture.h"

namespace vvr::app {

/// Where a picture that is not its golden one stays: `golden.candidate.png` beside `golden.png`.
std::filesystem::path candidate_of(const std::filesystem::path& golden);

/// Before anything is drawn: what a picture is to be compared with has to be one. That there is none is told
/// afterwards, with the candidate. \throws Error io
void check_golden_picture(const GoldenOptions& options);

/// Compares a picture, as a file would hold it, with the golden one, or blesses it. Afterwards there is a candidate
/// beside the golden picture only if they differ.
/// \throws Error differs when they do, or when there is no golden picture; io
void compare_with_golden(const GoldenOptions& options, const image::Picture& picture, const image::Metadata& metadata,
                 Observer& observer);

}  // namespace vvr::app
