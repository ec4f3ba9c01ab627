#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/events/patch.h"

namespace vvr::events {

/// What an object looks like: histograms of brightness and colour of its upper, middle and lower part. A person's coat
/// and trousers are told apart by it, whichever way the person turns.
class Appearance {
  public:
    Appearance() = default;
    Appearance(const Patch& patch, const FrameView& sight);

    /// Takes in another look at the same object. Early looks count more, late ones still follow the light.
    void learn(const Appearance& look);

    bool known() const { return looks_ > 0; }

    /// Hellinger's distance, the mean over parts and channels: 0 = the same, 1 = nothing in common.
    friend double distance(const Appearance& a, const Appearance& b);

  private:
    static constexpr int parts = 3;
    static constexpr int channels = 3;
    static constexpr int bins = 8;

    std::array<float, static_cast<std::size_t>(parts* channels* bins)> histogram_{};
    int looks_ = 0;
};

double distance(const Appearance& a, const Appearance& b);

/// What an object looked like when it was last seen alone.
struct Template {
    Patch patch;         ///< where it was then
    Plane<Bgr> colours;  ///< of the patch's box

    Template() = default;
    Template(Patch of, const FrameView& sight);
};

/// One of several objects that are one blob.
struct TemplateMatch {
    glm::ivec2 shift{};     ///< from the template's place to where it is now
    double similarity = 0;  ///< share of the template that is seen there, 0 to 1; less where others hide it
    Patch patch;            ///< pixels of the blob that are its own
};

/// Finds each of several objects within the blob that they are together, by what they looked like when alone: the one
/// that is seen best first, for it is in front, and the others in what is left.
/// \param expected shifts from the templates' places to where motion leads
std::vector<TemplateMatch> split_blob(const Patch& blob, const FrameView& sight,
                                      std::span<const Template* const> templates, std::span<const glm::ivec2> expected);

}  // namespace vvr::events
