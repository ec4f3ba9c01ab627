#pragma once

#include <span>
#include <vector>

#include "core/events/patch.h"
#include "core/events/sight.h"

namespace vvr::events {

/// What an object looked like when it was last seen alone.
struct Template {
    Patch patch;         ///< where it was then
    Plane<Bgr> colours;  ///< of the patch's box

    Template() = default;
    Template(Patch of, const FrameView& sight);
};

/// One of several objects that are one blob.
struct TemplateMatch {
    glm::ivec2 shift{};   ///< from the template's place to where it is now
    double similarity = 0;  ///< share of the template that is seen there, 0 to 1; less where others hide it
    Patch patch;          ///< pixels of the blob that are its own
};

/// Finds each of several objects within the blob that they are together, by what they looked like when alone: the one
/// that is seen best first, for it is in front, and the others in what is left.
/// \param expected shifts from the templates' places to where motion leads
std::vector<TemplateMatch> split_blob(const Patch& blob, const FrameView& sight, std::span<const Template* const> templates,
                              std::span<const glm::ivec2> expected);

}  // namespace vvr::events
