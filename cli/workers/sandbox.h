#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <linux/filter.h>

namespace vvr::workers {

/// Reports that a call of the kernel for a sandbox failed.
/// \param error a value of errno
[[noreturn]] void refuse_sandbox(std::string_view what, int error);

/// Access rights to a file, or to all files below a folder.
enum class Use {
    read,    ///< read files and list folders
    run,     ///< read and execute files
    change,  ///< read and write existing files
    write,   ///< create, write, replace and remove files, but neither read files nor list folders
    device,  ///< read, write and ioctl
};

/// Landlock lets a Linux process permanently give up access to all files that no rule allows. See landlock(7) and
/// https://docs.kernel.org/userspace-api/landlock.html. Debian 12 has no library for it, and its headers have only the
/// oldest rights.
struct Landlock {
    int abi = 0;    ///< version of the kernel's interface; 0 = not available
    int error = 0;  ///< why it is not available, as in errno
};

Landlock find_landlock();

/// The files and folders that a process may use. Also denies TCP, and signals to other processes, where the kernel
/// supports that.
class LandlockRules {
  public:
    /// \param abi from find_landlock, at least 1
    /// \throws Error backend when the kernel can't create the rules
    explicit LandlockRules(int abi);
    ~LandlockRules();
    LandlockRules(const LandlockRules&) = delete;
    LandlockRules& operator=(const LandlockRules&) = delete;

    /// Resolves symbolic links now, so the rule is for the file that exists now. A missing file needs no rule.
    void allow(const std::filesystem::path& path, Use use);

    /// Restricts the calling thread and all threads and processes that it starts later. Allocates nothing, so it may
    /// run between fork and exec. The thread must have set PR_SET_NO_NEW_PRIVS.
    /// \returns whether it succeeded
    bool enforce() const;

  private:
    int abi_;
    int rules_;
};

/// Why this kernel has no seccomp filters, as in errno; 0 = it has them.
int call_filter_error();

/// A seccomp filter with the system calls that a worker may make, some of them with certain arguments only. Others fail
/// with ENOSYS, as on an older kernel. A few that no library has a reason to make end the process with SIGSYS. A worker
/// can still start threads, allocate memory, compile shaders, and use the files that Landlock allows.
class CallFilter {
  public:
    /// \param gpu also allow the ioctls of graphics cards
    /// \throws Error backend when the filter can't be made
    explicit CallFilter(bool gpu);

    /// Applies to the calling thread and all threads and processes that it starts later. Allocates nothing, so it may
    /// run between fork and exec. The thread must have set PR_SET_NO_NEW_PRIVS. The calls that a worker needs to start
    /// stay allowed until block_startup_calls.
    /// \returns whether it succeeded
    bool enforce() const;

  private:
    std::vector<sock_filter> program_;
};

/// Gives up, for all threads of this process, the calls that a CallFilter allows only for startup: execve and seccomp.
/// Signals to other processes are denied too.
/// \returns whether it succeeded
bool block_startup_calls();

/// A file that drawing needs, or a folder with all files below it.
struct ProgramFile {
    std::filesystem::path path;
    Use use;
};

/// The files that every run of this program uses: the program and its libraries, OpenGL drivers, their shader cache,
/// fonts, and what the kernel reports about processors and memory. Some may not exist.
/// \param gpu also those for a graphics card
std::vector<ProgramFile> program_files(bool gpu);

/// Whether workers run in a sandbox.
enum class SandboxMode { automatic, off, required };

struct SandboxRow {
    SandboxMode mode;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array sandbox_modes{
    SandboxRow{SandboxMode::automatic, "auto", "whatever the kernel supports; the log lists it"},
    SandboxRow{SandboxMode::off, "off", "no restrictions"},
    SandboxRow{SandboxMode::required, "required",
               "all of it; if the kernel lacks a part, draw nothing and exit with 4"},
};

/// What all workers need in addition to their own clip.
struct SandboxNeeds {
    bool gpu = false;
    std::vector<std::filesystem::path> files{};  ///< that all workers read
};

/// The sandbox of one worker.
class Confinement {
  public:
    Confinement(std::unique_ptr<const LandlockRules> rules, const CallFilter* filter);

    /// Permanently confines the calling process and all processes that it starts. Allocates nothing, so it may run
    /// between fork and exec.
    /// \returns whether it succeeded; if not, the process must end
    bool enter() const;

    /// Whether system calls are filtered. If so, the worker must call block_startup_calls once it has begun.
    bool filters_calls() const { return filter_ != nullptr; }

  private:
    std::unique_ptr<const LandlockRules> rules_;
    const CallFilter* filter_;
};

/// The sandbox for the workers of a run. Landlock restricts files; a seccomp filter restricts the network, other
/// processes and the rest of the system.
class Sandbox {
  public:
    /// \throws Error backend when the sandbox is required but not complete; limit when it can't be made
    Sandbox(SandboxMode mode, const SandboxNeeds& needs);

    /// Whether everything that the mode asks for is in force.
    bool is_whole() const { return mode_ == SandboxMode::off || (landlock_.abi > 0 && filter_); }

    /// What is in force and what isn't, and why: one line for the log.
    std::string summary() const;

    /// The sandbox of a worker that reads `files` and writes into `folder`. It must not outlive this object.
    Confinement around(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder) const;

  private:
    SandboxMode mode_;
    std::vector<ProgramFile> shared_;  ///< used by all workers
    Landlock landlock_{};
    int no_filter_ = 0;  ///< why there is no filter, as in errno
    std::unique_ptr<const CallFilter> filter_{};
};

}  // namespace vvr::workers
