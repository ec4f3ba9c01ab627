/// Runs a program as if the kernel were an older one: `vvr-withhold landlock,seccomp PROGRAM ARGUMENT...`. Without
/// `network`, a call that opens a connection ends the program by a signal.
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

struct Call {
    std::string_view feature;
    const char* name;
    int error;  ///< that a kernel without the feature answers; 0: the call ends the program
    unsigned count;
    scmp_arg_cmp argument;
};

constexpr std::array calls{
    Call{"landlock", "landlock_create_ruleset", ENOSYS, 0, {}},
    Call{"landlock", "landlock_add_rule", ENOSYS, 0, {}},
    Call{"landlock", "landlock_restrict_self", ENOSYS, 0, {}},
    Call{"seccomp", "seccomp", ENOSYS, 0, {}},
    Call{"seccomp", "prctl", EINVAL, 1, {0, SCMP_CMP_EQ, PR_SET_SECCOMP, 0}},
    Call{"network", "connect", 0, 0, {}},
    Call{"network", "sendto", 0, 0, {}},
    Call{"network", "socket", 0, 1, {0, SCMP_CMP_EQ, AF_INET, 0}},
    Call{"network", "socket", 0, 1, {0, SCMP_CMP_EQ, AF_INET6, 0}},
};

bool withhold(std::string_view features) {
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    if (filter == nullptr) return false;
    for (const Call& call : calls) {
        if (features.find(call.feature) == std::string_view::npos) continue;
        const int number = seccomp_syscall_resolve_name(call.name);
        const auto error = static_cast<std::uint32_t>(call.error);
        const std::uint32_t action = call.error == 0 ? SCMP_ACT_KILL_PROCESS : SCMP_ACT_ERRNO(error);
        if (seccomp_rule_add_array(filter, action, number, call.count, &call.argument) < 0) return false;
    }
    return seccomp_load(filter) == 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 125;
    if (!withhold(argv[1])) {
        std::fprintf(stderr, "vvr-withhold: %s can't be withheld\n", argv[1]);
        return 125;
    }
    execvp(argv[2], argv + 2);
    std::perror("vvr-withhold");
    return 126;
}
