#include "cli/workers/system_calls.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

using Names = std::span<const char* const>;

// Sockets of every kind. io_uring would open them past this filter.
constexpr std::array network{"socket", "socketpair", "socketcall", "connect", "bind",    "listen",
                             "accept", "accept4",    "sendto",     "sendmsg", "sendmmsg"};

// Other processes: to start, to look into, to stop; and to leave the group by which a worker is ended. A program of
// another file is Landlock's matter: a worker begins with execve.
constexpr std::array processes{"fork",
                               "vfork",
                               "execveat",
                               "ptrace",
                               "process_vm_readv",
                               "process_vm_writev",
                               "process_madvise",
                               "process_mrelease",
                               "kcmp",
                               "pidfd_open",
                               "pidfd_getfd",
                               "pidfd_send_signal",
                               "kill",
                               "tkill",
                               "rt_sigqueueinfo",
                               "rt_tgsigqueueinfo",
                               "setpgid",
                               "setsid",
                               "unshare",
                               "setns"};

// What a file is beside its bytes, of which Landlock knows nothing; and truncation, which its oldest versions let pass.
constexpr std::array files{"chmod",
                           "fchmod",
                           "fchmodat",
                           "fchmodat2",
                           "chown",
                           "fchown",
                           "lchown",
                           "fchownat",
                           "setxattr",
                           "lsetxattr",
                           "fsetxattr",
                           "setxattrat",
                           "removexattr",
                           "lremovexattr",
                           "fremovexattr",
                           "removexattrat",
                           "utime",
                           "utimes",
                           "utimensat",
                           "futimesat",
                           "file_setattr",
                           "truncate",
                           "truncate64",
                           "creat",
                           "name_to_handle_at",
                           "open_by_handle_at"};

// Memory and queues that other programs of the user share.
constexpr std::array sharing{"shmget", "shmat", "shmctl",     "msgget", "msgsnd", "msgrcv",  "msgctl",
                             "semget", "semop", "semtimedop", "semctl", "ipc",    "mq_open", "mq_unlink"};

// The machine.
constexpr std::array machine{"mount",
                             "umount",
                             "umount2",
                             "pivot_root",
                             "chroot",
                             "open_tree",
                             "move_mount",
                             "fsopen",
                             "fsconfig",
                             "fsmount",
                             "fspick",
                             "mount_setattr",
                             "swapon",
                             "swapoff",
                             "quotactl",
                             "quotactl_fd",
                             "fanotify_init",
                             "fanotify_mark",
                             "acct",
                             "nfsservctl",
                             "bpf",
                             "perf_event_open",
                             "userfaultfd",
                             "keyctl",
                             "add_key",
                             "request_key",
                             "init_module",
                             "finit_module",
                             "create_module",
                             "delete_module",
                             "kexec_load",
                             "kexec_file_load",
                             "reboot",
                             "syslog",
                             "iopl",
                             "ioperm",
                             "lookup_dcookie",
                             "vhangup",
                             "settimeofday",
                             "stime",
                             "adjtimex",
                             "clock_settime",
                             "clock_adjtime",
                             "clock_adjtime64",
                             "clock_settime64",
                             "sethostname",
                             "setdomainname",
                             "uselib",
                             "ustat",
                             "sysfs",
                             "_sysctl",
                             "modify_ldt",
                             "vm86",
                             "vm86old",
                             "mknod",
                             "mknodat",
                             "personality",
                             "memfd_secret"};

// As on a kernel that is too old for them, for which callers have another way; the filter can't read their arguments.
constexpr std::array newer{"clone3", "openat2", "io_uring_setup", "io_uring_enter", "io_uring_register"};

struct Group {
    Names calls;
    int error;
};

constexpr std::array groups{Group{network, EACCES}, Group{processes, EPERM}, Group{files, EPERM},
                            Group{sharing, EPERM},  Group{machine, EPERM},   Group{newer, ENOSYS}};

/// Calls that are given up for some arguments alone.
struct Case {
    const char* call;
    scmp_arg_cmp arguments;
};

constexpr std::array cases{
    // Threads start, processes don't.
    Case{"clone", {0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0}},
    // Limits of the own process alone.
    Case{"prlimit64", {0, SCMP_CMP_NE, 0, 0}},
    Case{"open", {1, SCMP_CMP_MASKED_EQ, O_TRUNC, O_TRUNC}},
    Case{"openat", {2, SCMP_CMP_MASKED_EQ, O_TRUNC, O_TRUNC}},
};

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

/// The filter as the kernel takes it.
std::vector<sock_filter> compiled(scmp_filter_ctx filter) {
    const int file = ::memfd_create("vvr-filter", MFD_CLOEXEC);
    if (file < 0) refuse("memfd_create", errno);
    const int written = ::seccomp_export_bpf(filter, file);
    const off_t size = ::lseek(file, 0, SEEK_END);
    std::vector<sock_filter> program(static_cast<std::size_t>(std::max<off_t>(size, 0)) / sizeof(sock_filter));
    const ssize_t got = ::pread(file, program.data(), program.size() * sizeof(sock_filter), 0);
    const int error = errno;
    ::close(file);
    check(written, "seccomp_export_bpf");
    if (got != size || program.empty()) refuse("reading the filter", error);
    return program;
}

}  // namespace

int why_no_call_filter() {
    // A filter that is nowhere: what has filters says so, and what hasn't, that.
    return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) == -1 && errno != EFAULT ? errno : 0;
}

CallFilter::CallFilter() {
    const std::unique_ptr<void, Release> filter(::seccomp_init(SCMP_ACT_ALLOW));
    if (!filter) refuse("seccomp_init", ENOMEM);
    check(::seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2), "seccomp_attr_set");
    const auto forbid = [&](const char* name, int error, Names::size_type count, const scmp_arg_cmp* arguments) {
        const int call = ::seccomp_syscall_resolve_name(name);
        // Newer than the library, or another processor's; so is its number, then.
        if (call == __NR_SCMP_ERROR) return;
        const int added = ::seccomp_rule_add_array(filter.get(), SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)),
                                                   call, static_cast<unsigned>(count), arguments);
        if (added != -EDOM) check(added, name);
    };
    for (const Group& group : groups) {
        for (const char* const name : group.calls) forbid(name, group.error, 0, nullptr);
    }
    for (const Case& row : cases) forbid(row.call, EPERM, 1, &row.arguments);
    program_ = compiled(filter.get());
}

bool CallFilter::enforce() const {
    // The kernel's type has no const, and it changes nothing.
    const sock_fprog program{static_cast<unsigned short>(program_.size()), const_cast<sock_filter*>(program_.data())};
    return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace vvr
