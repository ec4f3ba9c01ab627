#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/workers/confine.h"

namespace vvr::workers {

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
