#include "core/base/version.h"

namespace vvr {

std::string_view version() {
    return VVR_VERSION;
}

}  // namespace vvr
