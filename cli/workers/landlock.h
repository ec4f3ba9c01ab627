#pragma once

#include <filesystem>

namespace vvr::workers {

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

}  // namespace vvr::workers
