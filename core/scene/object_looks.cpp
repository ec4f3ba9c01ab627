#include "core/scene/object_looks.h"

namespace vvr::scene {

namespace {

struct ObjectStateStyle {
    float extinction;  ///< factor
    float toward_ink;  ///< part of the way from the object's colour to black
};

// In the order of ObjectState. Who stands is in one place for long, and has to be told from a trail that runs along the
// arc: by stripes across time, and more solid.
constexpr std::array postures{ObjectStateStyle{1, 0}, ObjectStateStyle{1.5F, 0}, ObjectStateStyle{3, 0.45F}};

// Leaves, rain and the light are nobody's: to be seen where there is nothing else, and not to be taken for a thing. At
// a sixth a whole frame that has become lighter lets everything behind it through.
constexpr float nobodys_extinction = 1.0F / 6;

}  // namespace

std::uint8_t palette_index(int colour, ObjectState posture) {
    return static_cast<std::uint8_t>(1 + colour * static_cast<int>(postures.size()) + static_cast<int>(posture));
}

std::vector<glm::vec4> object_palette(const Theme& theme) {
    std::vector<glm::vec4> looks{{theme.unowned, nobodys_extinction}};
    for (const glm::vec3& colour : theme.objects) {
        for (const ObjectStateStyle& posture : postures) {
            looks.emplace_back(glm::mix(colour, glm::vec3(0), posture.toward_ink), posture.extinction);
        }
    }
    return looks;
}

}  // namespace vvr::scene
