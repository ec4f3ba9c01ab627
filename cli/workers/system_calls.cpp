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
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/workers/sandbox.h"
#include "core/base/error.h"

namespace vvr::workers::calls {

using Names = std::span<const char* const>;

inline constexpr std::array memory{"brk",     "mmap",    "mmap2",      "munmap",        "mremap",
                                   "madvise", "mincore", "mprotect",   "mlock",         "munlock",
                                   "msync",   "mbind",   "membarrier", "get_mempolicy", "set_mempolicy"};

// On open files, and on paths, which Landlock restricts. Left out: calls that create anything but a regular file, that
// change a file's metadata, or that write without being counted (fallocate, sendfile, splice).
inline constexpr std::array files{"read",
                                  "readv",
                                  "pread64",
                                  "preadv",
                                  "preadv2",
                                  "write",
                                  "writev",
                                  "pwrite64",
                                  "pwritev",
                                  "pwritev2",
                                  "lseek",
                                  "_llseek",
                                  "close",
                                  "close_range",
                                  "dup",
                                  "dup2",
                                  "dup3",
                                  "pipe",
                                  "pipe2",
                                  "eventfd2",
                                  "epoll_create1",
                                  "epoll_ctl",
                                  "epoll_wait",
                                  "epoll_pwait",
                                  "poll",
                                  "ppoll",
                                  "select",
                                  "_newselect",
                                  "pselect6",
                                  "fstat",
                                  "fstat64",
                                  "stat",
                                  "stat64",
                                  "lstat",
                                  "lstat64",
                                  "newfstatat",
                                  "fstatat64",
                                  "statx",
                                  "access",
                                  "faccessat",
                                  "faccessat2",
                                  "readlink",
                                  "readlinkat",
                                  "getdents",
                                  "getdents64",
                                  "getcwd",
                                  "rename",
                                  "renameat",
                                  "renameat2",
                                  "unlink",
                                  "unlinkat",
                                  "fsync",
                                  "fdatasync",
                                  "flock",
                                  "ftruncate",
                                  "ftruncate64",
                                  "statfs",
                                  "statfs64",
                                  "fstatfs",
                                  "fstatfs64",
                                  "fadvise64",
                                  "fadvise64_64",
                                  "arm_fadvise64_64",
                                  "pselect6_time64",
                                  "ppoll_time64"};

// About this process. A thread's orderly end and abort need tgkill; rt_sigtimedwait waits for SIGTERM.
inline constexpr std::array process{"exit",
                                    "exit_group",
                                    "futex",
                                    "futex_time64",
                                    "futex_waitv",
                                    "set_robust_list",
                                    "set_tid_address",
                                    "set_tls",
                                    "set_thread_area",
                                    "rseq",
                                    "arch_prctl",
                                    "cacheflush",
                                    "riscv_flush_icache",
                                    "riscv_hwprobe",
                                    "map_shadow_stack",
                                    "restart_syscall",
                                    "rt_sigaction",
                                    "rt_sigpending",
                                    "rt_sigprocmask",
                                    "rt_sigreturn",
                                    "rt_sigsuspend",
                                    "rt_sigtimedwait",
                                    "rt_sigtimedwait_time64",
                                    "sigaltstack",
                                    "sigreturn",
                                    "tgkill",
                                    "getpid",
                                    "getppid",
                                    "gettid",
                                    "getuid",
                                    "geteuid",
                                    "getgid",
                                    "getegid",
                                    "getuid32",
                                    "geteuid32",
                                    "getgid32",
                                    "getegid32",
                                    "getresuid",
                                    "getresgid",
                                    "getgroups",
                                    "getrlimit",
                                    "ugetrlimit",
                                    "getrusage",
                                    "getpriority",
                                    "getcpu",
                                    "sched_yield",
                                    "sched_getaffinity",
                                    "sched_getparam",
                                    "sched_getscheduler",
                                    "sched_get_priority_max",
                                    "sched_get_priority_min"};

inline constexpr std::array machine{"clock_getres",
                                    "clock_getres_time64",
                                    "clock_gettime",
                                    "clock_gettime64",
                                    "clock_nanosleep",
                                    "clock_nanosleep_time64",
                                    "nanosleep",
                                    "gettimeofday",
                                    "time",
                                    "times",
                                    "getrandom",
                                    "sysinfo",
                                    "uname"};

// Allowed until begin_worker: to exec vvr, and to deny these calls afterwards.
inline constexpr std::array beginning{"execve", "seccomp"};

inline constexpr std::array allowed{Names(memory), Names(files), Names(process), Names(machine), Names(beginning)};

// Graphics drivers share buffers in memory files.
inline constexpr std::array for_gpu{"memfd_create"};

// No library has a reason to make these calls. The process is killed at once.
inline constexpr std::array fatal{"ptrace",
                                  "process_vm_readv",
                                  "process_vm_writev",
                                  "bpf",
                                  "userfaultfd",
                                  "mount",
                                  "umount",
                                  "umount2",
                                  "move_mount",
                                  "open_tree",
                                  "fsopen",
                                  "fsmount",
                                  "mount_setattr",
                                  "pivot_root",
                                  "chroot",
                                  "unshare",
                                  "setns",
                                  "init_module",
                                  "finit_module",
                                  "delete_module",
                                  "kexec_load",
                                  "kexec_file_load",
                                  "reboot",
                                  "swapon",
                                  "swapoff",
                                  "execveat",
                                  "open_by_handle_at"};

/// A call that is allowed only if all the argument conditions hold.
struct Case {
    const char* call;
    std::array<scmp_arg_cmp, 2> arguments;
    unsigned count = 1;
};

constexpr scmp_arg_cmp equal(unsigned argument, scmp_datum_t value) {
    return {argument, SCMP_CMP_EQ, value, 0};
}

/// The condition that the argument's bits in `mask` equal those of `value`.
constexpr scmp_arg_cmp masked(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

// Allow threads, but no processes, namespaces, tracer or other parent.
inline constexpr scmp_datum_t of_threads = CLONE_THREAD | CLONE_VM | CLONE_SIGHAND;
inline constexpr scmp_datum_t of_others = CLONE_VFORK | CLONE_PARENT | CLONE_PTRACE | CLONE_UNTRACED | CLONE_PIDFD |
                                          CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                                          CLONE_NEWPID | CLONE_NEWNET;

// Opening a file must not truncate it (the oldest Landlock versions don't check that), create an unnamed file, or set
// the set-user-ID or set-group-ID bit. The mode counts only where a file is created.
inline constexpr scmp_datum_t without_name = O_TMPFILE & ~O_DIRECTORY;
inline constexpr scmp_datum_t making = O_CREAT | O_TRUNC | without_name;
inline constexpr scmp_datum_t rights_of_owner = 07000;
inline constexpr scmp_datum_t name_of_memory = 0x53564d41;  // PR_SET_VMA, which Debian 12's headers lack

inline constexpr std::array cases{
    Case{"clone", {masked(0, of_threads | of_others, of_threads)}},
    Case{"open", {masked(1, making, 0)}},
    Case{"open", {masked(1, making, O_CREAT), masked(2, rights_of_owner, 0)}, 2},
    Case{"openat", {masked(2, making, 0)}},
    Case{"openat", {masked(2, making, O_CREAT), masked(3, rights_of_owner, 0)}, 2},
    // Get limits, but don't set them; of this process only.
    Case{"prlimit64", {equal(0, 0), equal(2, 0)}, 2},
    // Neither PR_SET_PDEATHSIG nor PR_SET_DUMPABLE.
    Case{"prctl", {equal(0, PR_SET_NAME)}},
    Case{"prctl", {equal(0, PR_GET_NAME)}},
    Case{"prctl", {equal(0, PR_GET_DUMPABLE)}},
    Case{"prctl", {equal(0, PR_CAPBSET_READ)}},
    Case{"prctl", {equal(0, name_of_memory)}},
    // No signals to other processes through a file (F_SETOWN, F_SETSIG), no leases.
    Case{"fcntl", {equal(1, F_DUPFD)}},
    Case{"fcntl", {equal(1, F_DUPFD_CLOEXEC)}},
    Case{"fcntl", {equal(1, F_GETFD)}},
    Case{"fcntl", {equal(1, F_SETFD)}},
    Case{"fcntl", {equal(1, F_GETFL)}},
    Case{"fcntl", {equal(1, F_SETFL)}},
    Case{"fcntl64", {equal(1, F_DUPFD)}},
    Case{"fcntl64", {equal(1, F_DUPFD_CLOEXEC)}},
    Case{"fcntl64", {equal(1, F_GETFD)}},
    Case{"fcntl64", {equal(1, F_SETFD)}},
    Case{"fcntl64", {equal(1, F_GETFL)}},
    Case{"fcntl64", {equal(1, F_SETFL)}},
    Case{"ioctl", {equal(1, TCGETS)}},
    Case{"ioctl", {equal(1, FIONREAD)}},
    Case{"ioctl", {equal(1, TIOCGWINSZ)}},
};

/// The ioctls of each kind of graphics device have their own letter, different from those of file systems.
constexpr scmp_arg_cmp ioctls_of(unsigned char letter) {
    return masked(1, 0xFF00, static_cast<scmp_datum_t>(letter) << 8);
}

inline constexpr std::array cases_for_gpu{
    Case{"ioctl", {ioctls_of('d')}},  // DRM
    Case{"ioctl", {ioctls_of('b')}},  // dma-buf
    Case{"ioctl", {ioctls_of('>')}},  // sync_file
    Case{"ioctl", {ioctls_of('K')}},  // AMD's kfd
    Case{"ioctl", {ioctls_of('F')}},  // NVIDIA's
    Case{"ioctl", {ioctls_of(0)}},    // its uvm device uses plain numbers
    Case{"fcntl", {equal(1, F_ADD_SEALS)}}, Case{"fcntl", {equal(1, F_GET_SEALS)}},
};

}  // namespace vvr::workers::calls

namespace vvr::workers {

namespace {

/// libseccomp functions return a negative errno on failure.
void check(int answer, std::string_view what) {
    if (answer < 0) refuse_sandbox(what, -answer);
}

struct Release {
    void operator()(void* filter) const { ::seccomp_release(filter); }
};

constexpr bool is_big_endian = std::endian::native == std::endian::big;

/// The filter as a BPF program. libseccomp exports it only to a file descriptor; a pipe has room for the longest
/// program and is not subject to the file size limit.
std::vector<sock_filter> compiled(scmp_filter_ctx filter) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) refuse_sandbox("pipe", errno);
    const int written = ::seccomp_export_bpf(filter, pipe[1]);
    ::close(pipe[1]);
    std::vector<sock_filter> program(BPF_MAXINSNS);
    const ssize_t got = ::read(pipe[0], program.data(), program.size() * sizeof(sock_filter));
    const int error = errno;
    ::close(pipe[0]);
    check(written, "seccomp_export_bpf");
    if (got <= 0) refuse_sandbox("reading the filter", got < 0 ? error : ENODATA);
    program.resize(static_cast<std::size_t>(got) / sizeof(sock_filter));
    return program;
}

}  // namespace

int call_filter_error() {
    // A filter at a null address: EFAULT means that the kernel supports filters. Tries both calls that are used here.
    if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) == -1 && errno != EFAULT) return errno;
    const long set = ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, nullptr);
    return set == -1 && errno != EFAULT ? errno : 0;
}

CallFilter::CallFilter(bool gpu) {
    // Libraries expect ENOSYS from older kernels, and use another call or do without.
    const std::unique_ptr<void, Release> filter(::seccomp_init(SCMP_ACT_ERRNO(ENOSYS)));
    if (!filter) refuse_sandbox("seccomp_init", ENOMEM);
    check(::seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2), "seccomp_attr_set");
    // Calls with another architecture's numbers: 32 bits, or x32.
    check(::seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS), "seccomp_attr_set");
    const auto add = [&](std::uint32_t action, const char* name, unsigned count, const scmp_arg_cmp* arguments) {
        const int call = ::seccomp_syscall_resolve_name(name);
        // Unknown to the library, or (below 0) not on this architecture.
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
    // The kernel's type lacks const; the call changes nothing.
    const sock_fprog program{static_cast<unsigned short>(program_.size()), const_cast<sock_filter*>(program_.data())};
    return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

bool block_startup_calls() {
    // Written by hand, as a worker doesn't need libseccomp for it. The first filter has already checked the
    // architecture.
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
