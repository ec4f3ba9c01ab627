#include <vvr/library_version.h>

#include "core/base/version.h"

namespace vvr {

std::string library_version() {
    return std::string(version());
}

}  // namespace vvr
