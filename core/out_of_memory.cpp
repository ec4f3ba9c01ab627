#include "core/out_of_memory.h"

#include <new>
#include <string_view>
#include <system_error>

namespace vvr {

bool is_out_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
    const auto* const system = dynamic_cast<const std::system_error*>(&error);
    if (system != nullptr && system->code() == std::errc::resource_unavailable_try_again) return true;
    // TBB has no type of its own for a thread that it can't have.
    return std::string_view(error.what()).starts_with("pthread_create has failed");
}

}  // namespace vvr
