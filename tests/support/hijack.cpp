/// What a decoder would try that a hostile clip has taken over. Preloaded into vvr (LD_PRELOAD), it takes the place of
/// libav's function that opens a clip. With $HIJACK_OUT it tries all that such a worker should not be able to, and
/// writes a line for each into $HIJACK_OUT/hijacked: what it tried, and the error that it met; 0 = none. Without it the
/// clip's own name says what is done, or $HIJACK_LOSES names a file to remove.
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/fs.h>
#include <linux/io_uring.h>
#include <linux/perf_event.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
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
constexpr auto clip = [] { return place("HIJACK_CLIP"); };
constexpr auto other = [] { return place("HIJACK_OTHER"); };
constexpr auto outside = [] { return place("HIJACK_OUTSIDE"); };
constexpr auto out = [] { return place("HIJACK_OUT"); };

/// The error of a call that answers with less than 0.
int error_of(long answer) {
    return answer < 0 ? errno : 0;
}

/// The error of a call that answers with a file, which is closed again.
int error_of_file(int descriptor) {
    const int error = error_of(descriptor);
    if (descriptor >= 0) close(descriptor);
    return error;
}

int try_open(const std::string& file, int flags) {
    return error_of_file(open(file.c_str(), flags | O_CLOEXEC, 0600));
}

int try_socket(int family, int type) {
    return error_of_file(socket(family, type, 0));
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

/// With a file of its own beside its picture, which goes again.
template <class Use>
int with_file(Use use, int mode = 0600) {
    const std::string file = out() + "/hijack.own";
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor < 0) return errno;
    const int error = use(descriptor);
    close(descriptor);
    unlink(file.c_str());
    return error;
}

int try_flags() {
    return with_file([](int file) {
        int flags = 0;
        const int error = error_of(ioctl(file, FS_IOC_GETFLAGS, &flags));
        return error != 0 ? error : error_of(ioctl(file, FS_IOC_SETFLAGS, &flags));
    });
}

int try_own_limit() {
    rlimit limit{};
    getrlimit(RLIMIT_NOFILE, &limit);
    return error_of(setrlimit(RLIMIT_NOFILE, &limit));
}

int try_scheduler() {
    sched_param none{};
    return error_of(sched_setscheduler(getppid(), SCHED_BATCH, &none));
}

int try_processors() {
    cpu_set_t all{};
    const int error = error_of(sched_getaffinity(0, sizeof all, &all));
    return error != 0 ? error : error_of(sched_setaffinity(getppid(), sizeof all, &all));
}

int try_hiding() {
    const int error = error_of(prctl(PR_SET_DUMPABLE, 0));
    prctl(PR_SET_DUMPABLE, 1);
    return error;
}

int try_outliving() {
    const int error = error_of(prctl(PR_SET_PDEATHSIG, 0));
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    return error;
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

constexpr std::uint32_t allow = SECCOMP_RET_ALLOW;

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
    Attempt{"make a file with its owner's rights", [] { return with_file([](int) { return 0; }, 04755); }},
    Attempt{"make a file with its group's rights", [] { return with_file([](int) { return 0; }, 02755); }},
    Attempt{"give a file its owner's rights",
            [] { return with_file([](int f) { return error_of(fchmod(f, 04755)); }); }},
    Attempt{"make a file with creat", [] { return error_of(creat((out() + "/hijack.new").c_str(), 0600)); }},
    Attempt{"make a file without a name", [] { return try_open(out(), O_WRONLY | O_TMPFILE); }},
    Attempt{"make a file in memory", [] { return error_of_file(memfd_create("hijack", MFD_CLOEXEC)); }},
    Attempt{"make a FIFO", [] { return error_of(mkfifo((out() + "/fifo").c_str(), 0600)); }},
    Attempt{"set the flags of a file", try_flags},
    Attempt{"reserve room for a file", [] { return with_file([](int f) { return error_of(fallocate(f, 0, 0, 1)); }); }},
    Attempt{"make a giant file", [] { return with_file([](int f) { return error_of(ftruncate(f, 1LL << 40)); }); }},
    Attempt{"grow its plan", [] { return error_of(ftruncate(STDIN_FILENO, 1 << 20)); }},
    Attempt{"write into its plan", [] { return error_of(write(STDIN_FILENO, "x", 1)); }},
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
    Attempt{"set the parent's limits", try_limits},
    Attempt{"signal the parent by a file",
            [] { return with_file([](int f) { return error_of(fcntl(f, F_SETOWN, getppid())); }); }},
    Attempt{"outlive the parent", try_outliving},
    Attempt{"hide from the parent", try_hiding},
    Attempt{"set the parent's scheduler", try_scheduler},
    Attempt{
        "set the parent's priority",
        [] { return error_of(setpriority(PRIO_PROCESS, static_cast<id_t>(getppid()), getpriority(PRIO_PROCESS, 0))); }},
    Attempt{"set the parent's processors", try_processors},
    Attempt{"set its own limits", try_own_limit},
    Attempt{"leave its group", [] { return error_of(setsid()); }},
    Attempt{"share memory", try_sharing},
    // The machine.
    Attempt{"count events", try_perf},
    Attempt{"ask for filters", [] { return error_of(syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &allow)); }},
    Attempt{"use keys", [] { return error_of(syscall(SYS_keyctl, 0, -3, 0)); }},
};

void try_all() {
    std::string results;
    for (const Attempt& attempt : attempts) {
        results += std::string(attempt.name) + '\t' + std::to_string(attempt.make()) + '\n';
    }
    const int file = open((out() + "/hijacked").c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0 || write(file, results.data(), results.size()) < 0) std::perror("hijacked");
    if (file >= 0) close(file);
}

std::string report;  ///< of this worker

int become(int program) {
    static std::array<char*, 1> none{nullptr};
    if (program < 0) return execve("/bin/true", none.data(), none.data());
    return fexecve(program, none.data(), none.data());
}

void become_memory() {
    // What is already open will do where no file can be made in memory.
    const int copied = memfd_create("program", 0);
    become(copied < 0 ? STDIN_FILENO : copied);
}

void peek() {
    char byte = 0;
    iovec here{&byte, 1};
    process_vm_readv(getppid(), &here, 1, &here, 1, 0);
}

void call_as_32_bits() {
#ifdef __x86_64__
    int answer = 20;  // getpid
    asm volatile("int $0x80" : "+a"(answer) : : "memory");
#else
    raise(SIGSYS);
#endif
}

void call_as_x32() {
#ifdef __x86_64__
    syscall(0x40000000 + SYS_getpid);
#else
    raise(SIGSYS);
#endif
}

void end_with(int status, const char* words) {
    if (write(STDERR_FILENO, words, std::strlen(words)) < 0) status = 99;
    _exit(status);
}

/// To the parent, in the place of what vvr would tell.
void tell(int status, const char* message) {
    if (write(std::atoi(place("HIJACK_PARENT").c_str()), message, std::strlen(message)) < 0) status = 99;
    _exit(status);
}

void leave_report(const char* text, off_t size) {
    const int file = open(report.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (write(file, text, std::strlen(text)) < 0 || (size > 0 && ftruncate(file, size) != 0)) _exit(99);
    _exit(0);
}

/// \param most bytes; what is beyond is up to the parent
void write_on(int file, std::int64_t most) {
    static std::array<char, 1 << 16> words{};
    words.fill('x');
    for (std::int64_t written = 0; written < most; written += static_cast<std::int64_t>(words.size())) {
        if (write(file, words.data(), words.size()) < 0) _exit(98);
    }
}

void stay() {
    prctl(PR_SET_PDEATHSIG, 0);
    setsid();
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, SIG_IGN);
    for (;;) sleep(1);
}

struct Deed {
    std::string_view clip;  ///< its file's name, without the extension
    void (*make)();
};

constexpr std::array activities{
    // What ends a worker that is shut in, there and then.
    Deed{"execve", [] { become(-1); }},
    Deed{"execveat", become_memory},
    Deed{"ptrace", [] { ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr); }},
    Deed{"peek", peek},
    Deed{"mount", [] { mount("none", "/nowhere", "tmpfs", 0, nullptr); }},
    Deed{"unshare", [] { unshare(0); }},
    Deed{"bpf", [] { syscall(SYS_bpf, 0, nullptr, 0); }},
    Deed{"userfaultfd", [] { syscall(SYS_userfaultfd, O_CLOEXEC); }},
    Deed{"int80", call_as_32_bits},
    Deed{"x32", call_as_x32},
    // What should end this worker's clip alone.
    Deed{"exit-127", [] { end_with(127, "vvr: cannot execute\n"); }},
    Deed{"exit-2", [] { end_with(2, "vvr: cannot write: No space left on device; free some space\n"); }},
    Deed{"exit-4", [] { end_with(4, "vvr: no OpenGL\n"); }},
    Deed{"exit-5", [] { end_with(5, "vvr: out of memory\n"); }},
    Deed{"liar", [] { tell(2, R"({"code": "disk-full", "text": "No space\nleft", "warnings": 7})"); }},
    Deed{"vague", [] { tell(3, R"({"code": "not-a-code", "text": ["x"], "warnings": [{}]})"); }},
    Deed{"deep", [] { tell(3, std::string(50'000, '[').c_str()); }},
    Deed{"done", [] { _exit(0); }},
    Deed{"broken", [] { leave_report("{ \"frames\": ", 0); }},
    Deed{"sparse", [] { leave_report("{", 1'900'000'000); }},
    Deed{"closed", [] { close(STDERR_FILENO), sleep(1), _exit(3); }},
    Deed{"flood", [] { write_on(STDERR_FILENO, 100'000'000), _exit(3); }},
    Deed{"greedy", [] { write_on(open("/dev/null", O_WRONLY | O_CLOEXEC), INT64_MAX); }},
    Deed{"stay", stay},
};

bool is_worker = false;

/// The file that the plan of a worker, on its stdin, names for the report. The plan is CBOR: each text comes after its
/// length.
std::string planned_report() {
    std::string plan(1 << 20, 0);
    const ssize_t count = pread(STDIN_FILENO, plan.data(), plan.size(), 0);
    plan.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    constexpr std::string_view name = "\x66report";
    std::size_t at = plan.find(name);
    if (at == std::string::npos) return "";
    at += name.size();
    const auto byte = [&plan](std::size_t nth) { return std::size_t{static_cast<unsigned char>(plan[nth])}; };
    constexpr std::size_t text = 0x60;
    switch (const std::size_t head = byte(at)) {
        case 0x78:
            return plan.substr(at + 2, byte(at + 1));
        case 0x79:
            return plan.substr(at + 3, byte(at + 1) * 256 + byte(at + 2));
        default:
            return plan.substr(at + 1, head - text);
    }
}

[[gnu::constructor]] void look(int argc, char** argv) {
    is_worker = argc > 1 && std::strcmp(argv[1], "render") == 0;
    if (!is_worker) return;
    setenv("HIJACK_REPORT", planned_report().c_str(), 1);
    setenv("HIJACK_PARENT", place("VVR_WORKER").c_str(), 1);
}

/// Once per process, with the clip that is about to be opened.
void take_over(std::string_view opened) {
    if (!std::exchange(is_worker, false)) return;
    report = place("HIJACK_REPORT");
    if (!out().empty()) return try_all();
    opened = opened.substr(opened.rfind('/') + 1);
    opened = opened.substr(0, opened.rfind('.'));
    for (const Deed& deed : activities) {
        if (deed.clip == opened) deed.make();
    }
}

}  // namespace

/// In place of libav's.
extern "C" [[gnu::visibility("default")]] int avformat_open_input(void** context, const char* url, const void* format,
                                                                  void** options) {
    using Open = int (*)(void**, const char*, const void*, void**);
    static const auto real = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "avformat_open_input"));
    take_over(url == nullptr ? "" : url);
    return real(context, url, format, options);
}

/// In place of libav's. When a worker begins the preview of its page, the file $HIJACK_LOSES goes, as if the recorder
/// removed it. The clip is not opened again until its events are copied.
extern "C" [[gnu::visibility("default")]] int avcodec_send_frame(void* context, const void* frame) {
    using Send = int (*)(void*, const void*);
    static const auto real = reinterpret_cast<Send>(dlsym(RTLD_NEXT, "avcodec_send_frame"));
    if (!place("HIJACK_LOSES").empty()) unlink(place("HIJACK_LOSES").c_str());
    return real(context, frame);
}
