#pragma once

#include <array>
#include <span>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>

namespace vvr::workers::calls {

using Names = std::span<const char* const>;

inline constexpr std::array memory{"brk",     "mmap",    "mmap2",      "munmap",        "mremap",
                                   "madvise", "mincore", "mprotect",   "mlock",         "munlock",
                                   "msync",   "mbind",   "membarrier", "get_mempolicy", "set_mempolicy"};

// Opened ones, and names, by which Landlock decides. No call that makes anything but a regular file, that changes what
// a file is beside its bytes, or that writes without being counted (fallocate, sendfile, splice).
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

// Of the own process. tgkill ends threads in order, and abort needs it; rt_sigtimedwait waits for SIGTERM.
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

// Until a worker has begun (WorkerBegin): it becomes vvr, and gives up what it needed for that.
inline constexpr std::array beginning{"execve", "seccomp"};

inline constexpr std::array allowed{Names(memory), Names(files), Names(process), Names(machine), Names(beginning)};

// Graphics drivers share buffers by files in memory.
inline constexpr std::array for_gpu{"memfd_create"};

// What no library has a reason to call: who does is ended there and then.
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

/// Calls that are allowed for some arguments alone: all that are named hold.
struct Case {
    const char* call;
    std::array<scmp_arg_cmp, 2> arguments;
    unsigned count = 1;
};

constexpr scmp_arg_cmp equal(unsigned argument, scmp_datum_t value) {
    return {argument, SCMP_CMP_EQ, value, 0};
}

/// That the bits of `mask` are those of `value`.
constexpr scmp_arg_cmp masked(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

// Threads, no processes, and no namespaces of their own, no tracer, no other parent.
inline constexpr scmp_datum_t of_threads = CLONE_THREAD | CLONE_VM | CLONE_SIGHAND;
inline constexpr scmp_datum_t of_others = CLONE_VFORK | CLONE_PARENT | CLONE_PTRACE | CLONE_UNTRACED | CLONE_PIDFD |
                                          CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                                          CLONE_NEWPID | CLONE_NEWNET;

// Files are neither emptied by opening (of which Landlock's oldest versions know nothing) nor made without a name, nor
// made with rights of their user or group: the mode counts only where a file is made.
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
    // To ask for limits, not to set them; those of the own process.
    Case{"prlimit64", {equal(0, 0), equal(2, 0)}, 2},
    // Neither how a worker ends with its parent, nor whether that may look into it.
    Case{"prctl", {equal(0, PR_SET_NAME)}},
    Case{"prctl", {equal(0, PR_GET_NAME)}},
    Case{"prctl", {equal(0, PR_GET_DUMPABLE)}},
    Case{"prctl", {equal(0, PR_CAPBSET_READ)}},
    Case{"prctl", {equal(0, name_of_memory)}},
    // No signals for others by way of a file (F_SETOWN, F_SETSIG), no leases.
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

/// ioctls of a graphics card's devices have a letter of their own each; those of file systems are others.
constexpr scmp_arg_cmp ioctls_of(unsigned char letter) {
    return masked(1, 0xFF00, static_cast<scmp_datum_t>(letter) << 8);
}

inline constexpr std::array cases_for_gpu{
    Case{"ioctl", {ioctls_of('d')}},  // DRM
    Case{"ioctl", {ioctls_of('b')}},  // dma-buf
    Case{"ioctl", {ioctls_of('>')}},  // sync_file
    Case{"ioctl", {ioctls_of('K')}},  // AMD's kfd
    Case{"ioctl", {ioctls_of('F')}},  // NVIDIA's
    Case{"ioctl", {ioctls_of(0)}},    // its uvm, which has plain numbers
    Case{"fcntl", {equal(1, F_ADD_SEALS)}}, Case{"fcntl", {equal(1, F_GET_SEALS)}},
};

}  // namespace vvr::workers::calls
