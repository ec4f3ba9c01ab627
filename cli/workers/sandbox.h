#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/workers/landlock.h"
#include "cli/workers/system_calls.h"

namespace vvr::workers {

/// A file that drawing needs, or all below a folder.
struct ProgramFile {
    std::filesystem::path path;
    Use use;
};

/// What any run of this program reads of the machine, whatever it draws: the program and its libraries, OpenGL drivers
/// and their cache of shaders, fonts, and what the kernel says of processors and memory. Some of them may not be there.
/// \param gpu a graphics card as well
std::vector<ProgramFile> program_files(bool gpu);

/// Whether workers are shut in.
enum class SandboxMode { automatic, off, required };

struct SandboxRow {
    SandboxMode mode;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array sandbox_modes{
    SandboxRow{SandboxMode::automatic, "auto", "what the kernel has, and the log says what that is"},
    SandboxRow{SandboxMode::off, "off", "workers may do all that the user may"},
    SandboxRow{SandboxMode::required, "required", "all of it, or nothing is drawn, and the status is 4"},
};

/// What workers use, beside the files of one of them.
struct SandboxNeeds {
    bool gpu = false;
    std::vector<std::filesystem::path> files{};  ///< that all of them read
};

/// What one worker may do, and nothing else.
class Confinement {
  public:
    Confinement(std::unique_ptr<const LandlockRules> rules, const CallFilter* filter);

    /// Shuts the calling process in, and all that it starts or becomes, for good. Allocates nothing, so it may stand
    /// between fork and exec.
    /// \returns whether it did; if not, the process must end
    bool enter() const;

    /// Whether system calls are among what it gives up: then it has to give up the rest once it has begun.
    bool filters_calls() const { return filter_ != nullptr; }

  private:
    std::unique_ptr<const LandlockRules> rules_;
    const CallFilter* filter_;
};

/// Shuts the workers of a run in: Landlock keeps them from files, seccomp from the network, other processes and the
/// machine.
class Sandbox {
  public:
    /// \throws Error backend when it is required and the kernel has not all of it, or it can't be made
    Sandbox(SandboxMode mode, const SandboxNeeds& needs);

    /// Whether all that was asked for is in force.
    bool is_whole() const { return mode_ == SandboxMode::off || (landlock_.abi > 0 && filter_); }

    /// What is in force and what isn't, and why: a line for the log.
    std::string summary() const;

    /// The walls around a worker that reads `files` and writes into `folder`. Must not outlive the sandbox.
    Confinement around(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder) const;

  private:
    SandboxMode mode_;
    std::vector<ProgramFile> shared_;  ///< by all workers
    Landlock landlock_{};
    int no_filter_ = 0;  ///< why, as in errno
    std::unique_ptr<const CallFilter> filter_{};
};

}  // namespace vvr::workers
