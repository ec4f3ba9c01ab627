// What people call. The libraries that work with video take longer to load than all that a version has to say, so the
// program that stands on them is another one, and this becomes it.
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/exit_status.h"
#include "cli/print.h"
#include "cli/versions.h"
#include "core/error.h"

namespace {

using namespace vvr;

[[noreturn]] void become_program(char** argv) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / VVR_PROGRAM;
    ::execv(program.c_str(), argv);
    throw Error(ErrorKind::io, fmt::format("cannot start '{}': {}; install vvr again", program,
                                           std::generic_category().message(errno)));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2 || std::string_view(argv[1]) != "--version") become_program(argv);
    print(version_text() + "OpenGL: `vvr doctor` shows the renderers\n");
    return static_cast<int>(ExitStatus::done);
} catch (const Error& error) {
    fmt::print(stderr, "vvr: {}\n", error.what());
    return static_cast<int>(exit_status(error.kind()));
} catch (const std::exception& error) {
    fmt::print(stderr, "vvr: {}\n", error.what());
    return static_cast<int>(ExitStatus::io);
}
