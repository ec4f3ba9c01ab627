#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/tracking/patch.h"

namespace vvr::tracking {

/// The looks of an object: histograms of brightness and colour of its upper, middle and lower third. So coat and
/// trousers count separately, whichever way a person turns.
class Appearance {
  public:
    Appearance() = default;
    Appearance(const Patch& patch, const FrameView& sight);

    /// Averages another look at the same object in. Early looks count more; late ones still follow the light.
    void learn(const Appearance& other);

    bool known() const { return count_ > 0; }

    /// The Hellinger distance, from the mean Bhattacharyya coefficient of all parts and channels: 0 = the same, 1 =
    /// nothing in common. 0.5 where one of them is unknown.
    friend double distance(const Appearance& a, const Appearance& b);

  private:
    static constexpr int parts = 3;
    static constexpr int channels = 3;
    static constexpr int bins = 8;

    std::array<float, static_cast<std::size_t>(parts* channels* bins)> histogram_{};
    int count_ = 0;
};

double distance(const Appearance& a, const Appearance& b);

/// The pixels of an object when it was last seen alone.
struct Template {
    Patch patch;         ///< its place then
    Plane<Bgr> colours;  ///< those of the patch's box

    Template() = default;
    Template(Patch of, const FrameView& sight);
};

/// Where one of several objects is within a shared blob.
struct TemplateMatch {
    glm::ivec2 shift{};     ///< from the template's place to the current one
    double similarity = 0;  ///< mean similarity of the template's visible pixels, 0 to 1; occluded pixels count 0
    Patch patch;            ///< the object's pixels of the blob
};

/// Splits a shared blob into its objects by template matching. The best match comes first because that object is in
/// front; the next ones are matched with the remaining pixels.
/// \param expected one shift per template, from its place to the predicted one
/// \returns one match per template
std::vector<TemplateMatch> split_blob(const Patch& blob, const FrameView& sight,
                                      std::span<const Template* const> templates, std::span<const glm::ivec2> expected);

}  // namespace vvr::tracking
