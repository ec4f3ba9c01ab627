// A library for LD_PRELOAD that makes one call of a program fail, as it would where a disk is full or memory is short:
//
//   VVR_FAULT=read:17 VVR_FAULT_LOG=log LD_PRELOAD=libvvr_fail_nth.so vvr render clip.avi -o out.png
//
// `clock:3` sets the clock back by ten years from the third time on that it is asked for. `read:17+` fails the 17th and
// all after it, `count` fails nothing and says how many calls there were, and VVR_FAULT_IN=worker leaves the process
// alone that was started first and looks at those that it starts. What a process and its libraries call is counted from
// the beginning of main; what libc calls within itself is not seen.
//
// Lines of the log, whose first word after the kind is main or worker:
//   count main read 56
//   fault main read 17 /usr/lib/libavformat.so.59 /tmp/vvr+0x1234 ...     who asked, and who asked that
//   crash main 11 /usr/lib/libLLVM-15.so.1+0x42 ...                       a signal, and where
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>
#include <utility>

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

// libc has names that are its own, and its mmap as a system call gives an address as a number.
// NOLINTBEGIN(bugprone-reserved-identifier,performance-no-int-to-ptr)

// What glibc calls the functions that ours stand before.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
using Main = int (*)(int, char**, char**);
int __libc_start_main(Main, int, char**, Main, void (*)(), void (*)(), void*);
}

namespace {

/// A kind of call that can fail.
struct Kind {
    std::string_view name;
    int error;
    std::atomic<long> count = 0;
};

constinit Kind call_open{"open", EMFILE};
constinit Kind call_write{"write", ENOSPC};
constinit Kind call_fsync{"fsync", EIO};
constinit Kind call_rename{"rename", EIO};
constinit Kind call_read{"read", EIO};
constinit Kind call_malloc{"malloc", ENOMEM};
constinit Kind call_mmap{"mmap", ENOMEM};
constinit Kind call_thread{"pthread_create", EAGAIN};
constinit Kind call_clock{"clock", 0};
constexpr std::array kinds{&call_open,   &call_write, &call_fsync,  &call_rename, &call_read,
                           &call_malloc, &call_mmap,  &call_thread, &call_clock};

constexpr std::time_t jump = -10L * 365 * 24 * 3600;

struct Plan {
    bool counts = false;
    const Kind* kind = nullptr;  // which fails
    long nth = 0;
    bool for_ever = false;
};

Plan plan;
bool is_worker = false;
int log_file = -1;
Main program = nullptr;
std::atomic<bool> armed = false;
// What this library and libc do on behalf of a call that is looked at already is not looked at.
thread_local bool inside [[gnu::tls_model("initial-exec")]] = false;

class Inside {
  public:
    Inside() : before_(std::exchange(inside, true)) {}
    ~Inside() { inside = before_; }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

  private:
    bool before_;
};

/// A line of the log, put together without any memory of the heap.
class Line {
  public:
    Line& operator<<(std::string_view text) {
        const std::size_t room = text_.size() - 1 - length_;
        const std::size_t taken = text.size() < room ? text.size() : room;
        std::memcpy(text_.data() + length_, text.data(), taken);
        length_ += taken;
        return *this;
    }
    Line& operator<<(long number) {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), "%ld", number);
        return *this << std::string_view(digits.data());
    }
    /// The file and the place in it that an address of the program is of.
    Line& add_place(void* address) {
        Dl_info info{};
        if (::dladdr(address, &info) == 0 || info.dli_fname == nullptr) return *this << " ?";
        std::array<char, 32> offset{};
        std::snprintf(offset.data(), offset.size(), "+0x%zx",
                      static_cast<std::size_t>(static_cast<char*>(address) - static_cast<char*>(info.dli_fbase)));
        return *this << " " << std::string_view(info.dli_fname) << std::string_view(offset.data());
    }
    void log() {
        text_[length_++] = '\n';
        if (log_file >= 0) ::syscall(SYS_write, log_file, text_.data(), length_);
    }

  private:
    std::array<char, 8192> text_{};
    std::size_t length_ = 0;
};

std::string_view process() {
    return is_worker ? "worker" : "main";
}

void add_callers(Line& line) {
    std::array<void*, 48> callers{};
    const int count = ::backtrace(callers.data(), static_cast<int>(callers.size()));
    for (int i = 0; i < count; ++i) line.add_place(callers.at(static_cast<std::size_t>(i)));
}

/// Counts a call. \returns whether it is to fail; then errno says why
bool fails(Kind& kind) {
    if (inside || !armed.load(std::memory_order_relaxed)) return false;
    const long number = ++kind.count;
    if (plan.kind != &kind || (plan.for_ever ? number < plan.nth : number != plan.nth)) return false;
    if (number == plan.nth) {
        const Inside now;
        Line line;
        line << "fault " << process() << " " << kind.name << " " << number;
        add_callers(line);
        line.log();
    }
    errno = kind.error;
    return true;
}

void say_counts() {
    armed = false;
    if (!plan.counts) return;
    for (const Kind* kind : kinds) {
        Line line;
        line << "count " << process() << " " << kind->name << " " << kind->count.load();
        line.log();
    }
}

void say_crash(int signal) {
    inside = true;
    Line line;
    line << "crash " << process() << " " << static_cast<long>(signal);
    add_callers(line);
    line.log();
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

Plan read_plan() {
    Plan read;
    const char* const asked = std::getenv("VVR_FAULT");
    if (asked == nullptr) return read;
    const std::string_view text = asked;
    read.counts = text == "count";
    const std::size_t colon = text.find(':');
    for (const Kind* kind : kinds) {
        if (text.substr(0, colon) == kind->name) read.kind = kind;
    }
    if (colon != std::string_view::npos) read.nth = std::atol(asked + colon + 1);
    read.for_ever = text.ends_with('+') || read.kind == &call_clock;
    return read;
}

int run(int count, char** arguments, char** environment) {
    const char* const place = std::getenv("VVR_FAULT_IN");
    const bool workers_alone = place != nullptr && std::string_view(place) == "worker";
    is_worker = std::getenv("VVR_FAULT_STARTED") != nullptr;
    ::setenv("VVR_FAULT_STARTED", "1", 1);
    if (const char* const log = std::getenv("VVR_FAULT_LOG")) {
        log_file =
            static_cast<int>(::syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    }
    if (workers_alone == is_worker) plan = read_plan();
    std::array<void*, 1> first{};
    ::backtrace(first.data(), 1);  // which loads a library the first time
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::signal(signal, say_crash);
    std::atexit(say_counts);
    armed = plan.counts || plan.kind != nullptr;
    return program(count, arguments, environment);
}

template <class Function>
Function next(const char* name) {
    const Inside now;
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int open_at(int folder, const char* path, int flags, mode_t mode) {
    return fails(call_open) ? -1 : static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
}

bool takes_mode(int flags) {
    return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int count, char** arguments, Main begin, void (*end)(), void (*loader)(),
                      void* stack) {
    program = main;
    return next<decltype(&__libc_start_main)>("__libc_start_main")(run, count, arguments, begin, end, loader, stack);
}

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = takes_mode(flags) ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open_at(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = takes_mode(flags) ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open_at(folder, path, flags, mode);
}

int __open_2(const char* path, int flags) {
    return open_at(AT_FDCWD, path, flags, 0);
}

FILE* fopen(const char* path, const char* mode) {
    return fails(call_open) ? nullptr : next<decltype(&fopen)>("fopen")(path, mode);
}

int mkostemp(char* pattern, int flags) {
    return fails(call_open) ? -1 : next<decltype(&mkostemp)>("mkostemp")(pattern, flags);
}

ssize_t write(int file, const void* bytes, std::size_t size) {
    return fails(call_write) ? -1 : ::syscall(SYS_write, file, bytes, size);
}

ssize_t writev(int file, const iovec* parts, int count) {
    return fails(call_write) ? -1 : ::syscall(SYS_writev, file, parts, count);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
    return fails(call_write) ? -1 : ::syscall(SYS_pwrite64, file, bytes, size, offset);
}

int fsync(int file) {
    return fails(call_fsync) ? -1 : static_cast<int>(::syscall(SYS_fsync, file));
}

int rename(const char* from, const char* to) noexcept {
    return fails(call_rename) ? -1 : static_cast<int>(::syscall(SYS_rename, from, to));
}

ssize_t read(int file, void* bytes, std::size_t size) {
    return fails(call_read) ? -1 : ::syscall(SYS_read, file, bytes, size);
}

ssize_t __read_chk(int file, void* bytes, std::size_t size, std::size_t) {
    return fails(call_read) ? -1 : ::syscall(SYS_read, file, bytes, size);
}

ssize_t pread(int file, void* bytes, std::size_t size, off_t offset) {
    return fails(call_read) ? -1 : ::syscall(SYS_pread64, file, bytes, size, offset);
}

void* malloc(std::size_t size) noexcept {
    return fails(call_malloc) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return fails(call_malloc) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
    return fails(call_malloc) ? nullptr : __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return fails(call_malloc) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
    if (fails(call_malloc)) return ENOMEM;
    *place = __libc_memalign(alignment, size);
    return *place == nullptr ? ENOMEM : 0;
}

void* mmap(void* place, std::size_t size, int protection, int flags, int file, off_t offset) noexcept {
    if (fails(call_mmap)) return MAP_FAILED;
    return reinterpret_cast<void*>(::syscall(SYS_mmap, place, size, protection, flags, file, offset));
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) noexcept {
    if (fails(call_thread)) return EAGAIN;
    return next<decltype(&pthread_create)>("pthread_create")(thread, attributes, work, argument);
}

int clock_gettime(clockid_t clock, timespec* now) noexcept {
    const auto result = static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
    if (clock == CLOCK_REALTIME && fails(call_clock)) now->tv_sec += jump;
    return result;
}

int gettimeofday(timeval* now, void* zone) noexcept {
    const auto result = static_cast<int>(::syscall(SYS_gettimeofday, now, zone));
    if (fails(call_clock)) now->tv_sec += jump;
    return result;
}

std::time_t time(std::time_t* place) noexcept {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (place != nullptr) *place = now.tv_sec;
    return now.tv_sec;
}

// Where addresses have 64 bits these are the same.
int open64(const char*, int, ...) __attribute__((alias("open")));
int openat64(int, const char*, int, ...) __attribute__((alias("openat")));
int __open64_2(const char*, int) __attribute__((alias("__open_2")));
FILE* fopen64(const char*, const char*) __attribute__((alias("fopen")));
ssize_t pwrite64(int, const void*, std::size_t, off64_t) __attribute__((alias("pwrite")));
ssize_t pread64(int, void*, std::size_t, off64_t) __attribute__((alias("pread")));
void* mmap64(void*, std::size_t, int, int, int, off64_t) noexcept __attribute__((alias("mmap")));
void* aligned_alloc(std::size_t, std::size_t) noexcept __attribute__((alias("memalign")));

}  // extern "C"

// NOLINTEND(bugprone-reserved-identifier,performance-no-int-to-ptr)
