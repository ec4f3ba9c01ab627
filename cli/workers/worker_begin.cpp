#include "cli/workers/worker_begin.h"

#include <charconv>
#include <cstdlib>
#include <system_error>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/workers/system_calls.h"

namespace vvr::workers {

namespace {

constexpr std::string_view open_mark = ":open";
constexpr std::string_view shut_mark = ":shut";
constexpr int not_begun = 127;

}  // namespace

std::string worker_value(int ready, bool confined) {
    return fmt::format("{}{}", ready, confined ? shut_mark : open_mark);
}

void begin_worker() {
    const char* const variable = std::getenv(worker_variable.data());
    if (variable == nullptr) return;
    const std::string value = variable;
    ::unsetenv(worker_variable.data());
    int ready = -1;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), ready);
    const std::string_view mark(end, static_cast<std::size_t>(value.data() + value.size() - end));
    if (error != std::errc() || ready <= STDERR_FILENO || (mark != open_mark && mark != shut_mark)) return;
    if (mark == shut_mark && !block_startup_calls()) {
        constexpr std::string_view words = "vvr: the system lets no worker into its sandbox; try --sandbox off\n";
        [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, words.data(), words.size());
        ::_exit(not_begun);
    }
    [[maybe_unused]] const ssize_t told = ::write(ready, "", 1);
    ::close(ready);
}

}  // namespace vvr::workers
