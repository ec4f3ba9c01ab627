#include "cli/print.h"

#include <span>

#include "core/base/standard_output.h"

namespace vvr::cli {

void print(std::string_view text) {
    write_standard_output(std::as_bytes(std::span(text)));
}

}  // namespace vvr::cli
