#include "gl/memory.h"

#include <cstdint>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/machine_memory.h"

namespace vvr::gl {

void throw_if_out_of_memory(std::string_view failure) {
    constexpr std::int64_t taken = 256'000'000;  // by a driver, its compiler and a small picture
    if (is_memory_available(taken)) return;
    throw Error(ErrorKind::limit,
                fmt::format("out of memory for OpenGL: {}; allow the program more, or try a smaller picture or smaller "
                            "fields",
                            failure),
                {"size", "field-size"});
}

}  // namespace vvr::gl
