#include "core/machine_memory.h"

#include <unistd.h>

namespace vvr {

std::int64_t machine_memory() {
    return std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE);
}

}  // namespace vvr
