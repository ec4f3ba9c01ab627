#include "cli/workers/system_calls.h"

#include <array>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <linux/bpf_common.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/workers/allowed_calls.h"
#include "core/base/error.h"

namespace vvr::workers {

namespace {

[[noreturn]] void refuse(std::string_view what, int error) {
    throw Error(ErrorKind::limit, fmt::format("cannot make a worker's sandbox: {}: {}; try --sandbox off", what,
                                              std::generic_category().message(error)));
}

/// libseccomp answers with an error below 0.
void check(int answer, std::string_view what) {
    if (answer < 0) refuse(what, -answer);
}

struct Release {
    void operator()(void* filter) const { ::seccomp_release(filter); }
};

constexpr bool is_big_endian = std::endian::native == std::endian::big;

/// The filter as the kernel takes it. Through a pipe, which has room for the longest there can be, and no limit on
/// files.
std::vector<sock_filter> compiled(scmp_filter_ctx filter) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) refuse("pipe", errno);
    const int written = ::seccomp_export_bpf(filter, pipe[1]);
    ::close(pipe[1]);
    std::vector<sock_filter> program(BPF_MAXINSNS);
    const ssize_t got = ::read(pipe[0], program.data(), program.size() * sizeof(sock_filter));
    const int error = errno;
    ::close(pipe[0]);
    check(written, "seccomp_export_bpf");
    if (got <= 0) refuse("reading the filter", got < 0 ? error : ENODATA);
    program.resize(static_cast<std::size_t>(got) / sizeof(sock_filter));
    return program;
}

}  // namespace

int call_filter_error() {
    // A filter that is nowhere: what has filters says so, and what hasn't, that. In both ways in which one is set here.
    if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) == -1 && errno != EFAULT) return errno;
    const long set = ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, nullptr);
    return set == -1 && errno != EFAULT ? errno : 0;
}

CallFilter::CallFilter(bool gpu) {
    // ENOSYS, as of an older kernel, is what libraries are made for: they do without, or have another way.
    const std::unique_ptr<void, Release> filter(::seccomp_init(SCMP_ACT_ERRNO(ENOSYS)));
    if (!filter) refuse("seccomp_init", ENOMEM);
    check(::seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2), "seccomp_attr_set");
    // Calls in the manner of another processor: 32 bits, or x32.
    check(::seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS), "seccomp_attr_set");
    const auto add = [&](std::uint32_t action, const char* name, unsigned count, const scmp_arg_cmp* arguments) {
        const int call = ::seccomp_syscall_resolve_name(name);
        // Newer than the library, or another processor's, whose numbers are below 0.
        if (call < 0) return;
        check(::seccomp_rule_add_array(filter.get(), action, call, count, arguments), name);
    };
    const auto allow_cases = [&](std::span<const calls::Case> rows) {
        for (const calls::Case& row : rows) add(SCMP_ACT_ALLOW, row.call, row.count, row.arguments.data());
    };
    for (const calls::Names& names : calls::allowed) {
        for (const char* const name : names) add(SCMP_ACT_ALLOW, name, 0, nullptr);
    }
    allow_cases(calls::cases);
    if (gpu) {
        for (const char* const name : calls::for_gpu) add(SCMP_ACT_ALLOW, name, 0, nullptr);
        allow_cases(calls::cases_for_gpu);
    }
    for (const char* const name : calls::fatal) add(SCMP_ACT_KILL_PROCESS, name, 0, nullptr);
    program_ = compiled(filter.get());
}

bool CallFilter::enforce() const {
    // The kernel's type has no const, and it changes nothing.
    const sock_fprog program{static_cast<unsigned short>(program_.size()), const_cast<sock_filter*>(program_.data())};
    return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

bool block_startup_calls() {
    // Written by hand: a worker has no use for the library. The filter before this one has seen to the architecture.
    constexpr std::uint32_t refused = SECCOMP_RET_ERRNO | EPERM;
    const auto own = static_cast<std::uint32_t>(::getpid());
    constexpr std::uint32_t call = offsetof(seccomp_data, nr);
    constexpr std::uint32_t first_argument = offsetof(seccomp_data, args) + (is_big_endian ? 4 : 0);
    std::array rules{
        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, call),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execve, 5, 0),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_seccomp, 5, 0),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_tgkill, 0, 2),
        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, first_argument),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own, 0, 2),
        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        sock_filter BPF_STMT(BPF_RET | BPF_K, refused),
    };
    const sock_fprog program{rules.size(), rules.data()};
    return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
}

}  // namespace vvr::workers
