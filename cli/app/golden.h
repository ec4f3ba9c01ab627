#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/image/comparison.h"
#include "core/image/picture.h"

namespace vvr::app {

/// The numbers, one a line.
std::string numbers_of(const image::Comparison& comparison);

/// The same for programs; what was not reached is null.
nlohmann::ordered_json json_of(const image::Comparison& comparison);

/// Shows where two pictures differ: the worst pixels, and a picture made of letters. Nothing where there are no
/// numbers.
/// \param a what the first picture is, in a word; `b` the second
void show_difference(const image::Comparison& comparison, const image::Tolerance& tolerance, std::string_view a,
                     std::string_view b, Observer& observer);

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
