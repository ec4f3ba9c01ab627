#include "core/archive/shard.h"

#include "core/base/fnv.h"

namespace vvr::archive {

bool Shard::contains(std::string_view clip) const {
    return fnv1a(clip) % count == index;
}

}  // namespace vvr::archive
