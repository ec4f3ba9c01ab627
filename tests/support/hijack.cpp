/// What a decoder would try that a hostile clip has taken over. Preloaded into vvr (LD_PRELOAD), it tries all of it
/// when an archive's worker starts, before main, and writes a line for each into $HIJACK_OUT/hijacked: what it tried,
/// and the error that it met; 0 = none.
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include <fcntl.h>
#include <linux/io_uring.h>
#include <linux/perf_event.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

std::string place(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// Functions, as no variable of this file is made yet when it begins.
std::string clip() {
    return place("HIJACK_CLIP");
}

std::string other() {
    return place("HIJACK_OTHER");
}

std::string outside() {
    return place("HIJACK_OUTSIDE");
}

std::string out() {
    return place("HIJACK_OUT");
}

/// The error of a call that answers with less than 0.
int error_of(long answer) {
    return answer < 0 ? errno : 0;
}

int try_open(const std::string& file, int flags) {
    const int descriptor = open(file.c_str(), flags | O_CLOEXEC, 0600);
    const int error = error_of(descriptor);
    if (descriptor >= 0) close(descriptor);
    return error;
}

int try_socket(int family, int type) {
    const int descriptor = socket(family, type, 0);
    const int error = error_of(descriptor);
    if (descriptor >= 0) close(descriptor);
    return error;
}

int try_fork() {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    const int error = error_of(child);
    if (child > 0) waitpid(child, nullptr, 0);
    return error;
}

int try_thread() {
    try {
        std::thread([] {}).join();
        return 0;
    } catch (const std::system_error& error) {
        return error.code().value();
    }
}

int try_code() {
    constexpr std::size_t page = 4096;
    void* const code = mmap(nullptr, page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const int error = error_of(mprotect(code, page, PROT_READ | PROT_EXEC));
    munmap(code, page);
    return error;
}

int try_rename() {
    const std::string from = out() + "/hijack.part";
    if (const int error = try_open(from, O_WRONLY | O_CREAT | O_EXCL)) return error;
    return error_of(rename(from.c_str(), (out() + "/hijack.whole").c_str()));
}

int try_peek() {
    char byte = 0;
    iovec here{&byte, 1};
    iovec there{&byte, 1};
    return error_of(process_vm_readv(getppid(), &here, 1, &there, 1, 0));
}

int try_limits() {
    rlimit limit{};
    return error_of(prlimit(getppid(), RLIMIT_NOFILE, nullptr, &limit));
}

int try_sharing() {
    const int memory = shmget(IPC_PRIVATE, 4096, 0600);
    const int error = error_of(memory);
    if (memory >= 0) shmctl(memory, IPC_RMID, nullptr);
    return error;
}

/// Only where it fails: what a program of another file does is not tried.
int try_program() {
    std::array<char*, 1> none{nullptr};
    execve("/bin/true", none.data(), none.data());
    return errno;
}

int try_perf() {
    perf_event_attr counted{};
    counted.size = sizeof counted;
    counted.type = PERF_TYPE_SOFTWARE;
    counted.exclude_kernel = 1;
    return error_of(syscall(SYS_perf_event_open, &counted, 0, -1, -1, 0));
}

int try_ring() {
    io_uring_params wanted{};
    return error_of(syscall(SYS_io_uring_setup, 1, &wanted));
}

struct Attempt {
    const char* name;
    int (*make)();
};

constexpr std::array attempts{
    // What drawing needs.
    Attempt{"read its clip", [] { return try_open(clip(), O_RDONLY); }},
    Attempt{"write and rename beside its picture", try_rename},
    Attempt{"remove beside its picture", [] { return error_of(unlink((out() + "/hijack.whole").c_str())); }},
    Attempt{"start a thread", try_thread},
    Attempt{"compile code", try_code},
    // Files.
    Attempt{"read another clip", [] { return try_open(other(), O_RDONLY); }},
    Attempt{"read a file of the user", [] { return try_open(outside(), O_RDONLY); }},
    Attempt{"list the folder of clips",
            [] { return try_open(clip().substr(0, clip().rfind('/')), O_RDONLY | O_DIRECTORY); }},
    Attempt{"list the folder of pictures", [] { return try_open(out(), O_RDONLY | O_DIRECTORY); }},
    Attempt{"write its clip", [] { return try_open(clip(), O_WRONLY); }},
    Attempt{"append to another clip", [] { return try_open(other(), O_WRONLY | O_APPEND); }},
    Attempt{"make a file elsewhere", [] { return try_open(outside() + ".new", O_WRONLY | O_CREAT); }},
    Attempt{"empty its clip by opening", [] { return try_open(clip(), O_RDONLY | O_TRUNC); }},
    Attempt{"empty its clip", [] { return error_of(truncate(clip().c_str(), 0)); }},
    Attempt{"remove its clip", [] { return error_of(unlink(clip().c_str())); }},
    Attempt{"move its clip", [] { return error_of(rename(clip().c_str(), (out() + "/moved").c_str())); }},
    Attempt{"link its clip", [] { return error_of(link(clip().c_str(), (out() + "/linked").c_str())); }},
    Attempt{"lay a link", [] { return error_of(symlink("/etc/passwd", (out() + "/laid").c_str())); }},
    Attempt{"make a folder", [] { return error_of(mkdir((out() + "/folder").c_str(), 0700)); }},
    Attempt{"let all read its clip", [] { return error_of(chmod(clip().c_str(), 0777)); }},
    Attempt{"read the parent's environment",
            [] { return try_open("/proc/" + std::to_string(getppid()) + "/environ", O_RDONLY); }},
    // Network.
    Attempt{"open a TCP socket", [] { return try_socket(AF_INET, SOCK_STREAM); }},
    Attempt{"open a UDP socket", [] { return try_socket(AF_INET, SOCK_DGRAM); }},
    Attempt{"open a UNIX socket", [] { return try_socket(AF_UNIX, SOCK_STREAM); }},
    Attempt{"open a netlink socket", [] { return try_socket(AF_NETLINK, SOCK_RAW); }},
    Attempt{"open a ring", try_ring},
    // Other processes.
    Attempt{"start a process", try_fork},
    Attempt{"signal the parent", [] { return error_of(kill(getppid(), 0)); }},
    Attempt{"signal the parent's thread", [] { return error_of(syscall(SYS_tgkill, getppid(), getppid(), 0)); }},
    Attempt{"trace the parent", [] { return error_of(ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr)); }},
    Attempt{"read the parent's memory", try_peek},
    Attempt{"set the parent's limits", try_limits},
    Attempt{"leave its group", [] { return error_of(setsid()); }},
    Attempt{"share memory", try_sharing},
    // The machine.
    Attempt{"mount", [] { return error_of(mount("none", outside().c_str(), "tmpfs", 0, nullptr)); }},
    Attempt{"make namespaces", [] { return error_of(unshare(CLONE_NEWUSER)); }},
    Attempt{"load BPF", [] { return error_of(syscall(SYS_bpf, 0, nullptr, 0)); }},
    Attempt{"count events", try_perf},
    Attempt{"handle page faults", [] { return error_of(syscall(SYS_userfaultfd, O_CLOEXEC)); }},
    Attempt{"use keys", [] { return error_of(syscall(SYS_keyctl, 0, -3, 0)); }},
};

/// The last one: if it succeeds, there is nothing left to write it down.
constexpr Attempt program{"start a program", try_program};

[[gnu::constructor]] void begin(int argc, char** argv) {
    if (argc < 2 || std::strcmp(argv[1], "render") != 0 || out().empty()) return;
    std::string results;
    const auto add = [&results](const char* name, int error) {
        results += std::string(name) + '\t' + std::to_string(error) + '\n';
    };
    for (const Attempt& attempt : attempts) add(attempt.name, attempt.make());
    if (std::getenv("HIJACK_PROGRAM") != nullptr) add(program.name, program.make());
    const int file = open((out() + "/hijacked").c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0 || write(file, results.data(), results.size()) < 0) std::perror("hijacked");
    if (file >= 0) close(file);
}

}  // namespace
