#pragma once

#include <span>
#include <string_view>

namespace vvr::detector {

/// The role of a class of objects in a scene.
enum class Group {
    person,
    vehicle,  ///< carries people or goods
    animal,
    thing,  ///< what a person can carry, leave and take
    other,  ///< furniture and fixtures
};

struct ObjectClass {
    std::string_view name;
    Group group;
};

/// The 80 classes of the COCO data set; the place of a row is the number that models give the class.
std::span<const ObjectClass> object_classes();

/// The class of that name; null = there is none.
const ObjectClass* find_class(std::string_view name);

std::string_view name_of(Group group);

/// Whether it moves by itself: nobody leaves or takes it.
constexpr bool lives_or_drives(Group group) {
    return group == Group::person || group == Group::vehicle || group == Group::animal;
}

}  // namespace vvr::detector
