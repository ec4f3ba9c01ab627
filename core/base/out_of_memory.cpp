#include "core/base/out_of_memory.h"

#include <new>
#include <string_view>
#include <system_error>

namespace vvr {

bool is_out_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
    if (const auto* const system = dynamic_cast<const std::system_error*>(&error)) {
        return system->code() == std::errc::resource_unavailable_try_again ||
               system->code() == std::errc::not_enough_memory;
    }
    // TBB has no type of its own for a thread that it can't have.
    return std::string_view(error.what()).starts_with("pthread_create has failed");
}

}  // namespace vvr
