#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cli/plan/observer.h"
#include "cli/plan/settings.h"
#include "core/image/comparison.h"
#include "core/image/picture.h"

namespace vvr::app {

/// Shows where two pictures differ: the worst pixels, and a map of letters. Shows nothing if there are no numbers.
/// \param a a word for the first picture; `b` for the second
void show_difference(const image::Comparison& comparison, const image::Tolerance& tolerance, std::string_view a,
                     std::string_view b, Observer& observer);

/// The file for a picture that differs from its golden one: `golden.candidate.png` for `golden.png`.
std::filesystem::path candidate_of(const std::filesystem::path& golden);

/// Checks before drawing that an existing golden file is a picture. A missing one is reported after drawing, with the
/// candidate.
/// \throws Error io
void check_golden_picture(const GoldenOptions& options);

/// Compares a picture, as a file would store it, with the golden picture, or replaces the latter when blessing. Leaves
/// a candidate beside the golden picture only if they differ.
/// \throws Error differs when they differ or there is no golden picture; io
void compare_with_golden(const GoldenOptions& options, const image::Picture& picture, const image::Metadata& metadata,
                         Observer& observer);

}  // namespace vvr::app
