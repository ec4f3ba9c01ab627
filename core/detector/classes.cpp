#include "core/detector/classes.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace vvr::detector {

namespace {

constexpr std::array classes{
    ObjectClass{"person", Group::person},
    ObjectClass{"bicycle", Group::vehicle},
    ObjectClass{"car", Group::vehicle},
    ObjectClass{"motorcycle", Group::vehicle},
    ObjectClass{"airplane", Group::vehicle},
    ObjectClass{"bus", Group::vehicle},
    ObjectClass{"train", Group::vehicle},
    ObjectClass{"truck", Group::vehicle},
    ObjectClass{"boat", Group::vehicle},
    ObjectClass{"traffic light", Group::other},
    ObjectClass{"fire hydrant", Group::other},
    ObjectClass{"stop sign", Group::other},
    ObjectClass{"parking meter", Group::other},
    ObjectClass{"bench", Group::other},
    ObjectClass{"bird", Group::animal},
    ObjectClass{"cat", Group::animal},
    ObjectClass{"dog", Group::animal},
    ObjectClass{"horse", Group::animal},
    ObjectClass{"sheep", Group::animal},
    ObjectClass{"cow", Group::animal},
    ObjectClass{"elephant", Group::animal},
    ObjectClass{"bear", Group::animal},
    ObjectClass{"zebra", Group::animal},
    ObjectClass{"giraffe", Group::animal},
    ObjectClass{"backpack", Group::thing},
    ObjectClass{"umbrella", Group::thing},
    ObjectClass{"handbag", Group::thing},
    ObjectClass{"tie", Group::thing},
    ObjectClass{"suitcase", Group::thing},
    ObjectClass{"frisbee", Group::thing},
    ObjectClass{"skis", Group::thing},
    ObjectClass{"snowboard", Group::thing},
    ObjectClass{"sports ball", Group::thing},
    ObjectClass{"kite", Group::thing},
    ObjectClass{"baseball bat", Group::thing},
    ObjectClass{"baseball glove", Group::thing},
    ObjectClass{"skateboard", Group::thing},
    ObjectClass{"surfboard", Group::thing},
    ObjectClass{"tennis racket", Group::thing},
    ObjectClass{"bottle", Group::thing},
    ObjectClass{"wine glass", Group::thing},
    ObjectClass{"cup", Group::thing},
    ObjectClass{"fork", Group::thing},
    ObjectClass{"knife", Group::thing},
    ObjectClass{"spoon", Group::thing},
    ObjectClass{"bowl", Group::thing},
    ObjectClass{"banana", Group::thing},
    ObjectClass{"apple", Group::thing},
    ObjectClass{"sandwich", Group::thing},
    ObjectClass{"orange", Group::thing},
    ObjectClass{"broccoli", Group::thing},
    ObjectClass{"carrot", Group::thing},
    ObjectClass{"hot dog", Group::thing},
    ObjectClass{"pizza", Group::thing},
    ObjectClass{"donut", Group::thing},
    ObjectClass{"cake", Group::thing},
    ObjectClass{"chair", Group::other},
    ObjectClass{"couch", Group::other},
    ObjectClass{"potted plant", Group::other},
    ObjectClass{"bed", Group::other},
    ObjectClass{"dining table", Group::other},
    ObjectClass{"toilet", Group::other},
    ObjectClass{"tv", Group::other},
    ObjectClass{"laptop", Group::thing},
    ObjectClass{"mouse", Group::thing},
    ObjectClass{"remote", Group::thing},
    ObjectClass{"keyboard", Group::thing},
    ObjectClass{"cell phone", Group::thing},
    ObjectClass{"microwave", Group::other},
    ObjectClass{"oven", Group::other},
    ObjectClass{"toaster", Group::other},
    ObjectClass{"sink", Group::other},
    ObjectClass{"refrigerator", Group::other},
    ObjectClass{"book", Group::thing},
    ObjectClass{"clock", Group::other},
    ObjectClass{"vase", Group::thing},
    ObjectClass{"scissors", Group::thing},
    ObjectClass{"teddy bear", Group::thing},
    ObjectClass{"hair drier", Group::thing},
    ObjectClass{"toothbrush", Group::thing},
};

constexpr std::array<std::string_view, 5> group_names{"person", "vehicle", "animal", "thing", "other"};

}  // namespace

std::span<const ObjectClass> object_classes() {
    return classes;
}

const ObjectClass* find_class(std::string_view name) {
    const auto found = std::ranges::find(classes, name, &ObjectClass::name);
    return found == classes.end() ? nullptr : &*found;
}

std::string_view name_of(Group group) {
    return group_names.at(static_cast<std::size_t>(group));
}

}  // namespace vvr::detector
