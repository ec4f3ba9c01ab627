#pragma once

#include <filesystem>

namespace vvr::workers {

/// What a process may do with a file, or with all files below a folder.
enum class Use {
    read,    ///< read them and list folders
    run,     ///< read and execute them
    change,  ///< read and write what is there
    write,   ///< make, write, replace and remove files; neither read them nor list their folder
    device,  ///< read, write and control
};

/// Landlock, by which a Linux process gives up files for good: all that no rule names. See landlock(7) and
/// https://docs.kernel.org/userspace-api/landlock.html; there is no library of it in Debian 12, whose headers know the
/// oldest rights alone.
struct Landlock {
    int abi = 0;    ///< version of the kernel's interface; 0 = none
    int error = 0;  ///< why there is none, as in errno
};

Landlock find_landlock();

/// Files and folders that a process may use, and no others. Network and signals to others are given up as well, where
/// the kernel can.
class LandlockRules {
  public:
    /// \param abi that of find_landlock, at least 1
    /// \throws Error backend when the kernel has no room for it
    explicit LandlockRules(int abi);
    ~LandlockRules();
    LandlockRules(const LandlockRules&) = delete;
    LandlockRules& operator=(const LandlockRules&) = delete;

    /// Links are followed now, so a rule is about the file that is there now. What is not there needs no rule.
    void allow(const std::filesystem::path& path, Use use);

    /// Holds for the calling thread and for what it starts from now on. Allocates nothing, so it may stand between fork
    /// and exec. The thread must have given up new privileges (PR_SET_NO_NEW_PRIVS).
    /// \returns whether it does
    bool enforce() const;

  private:
    int abi_;
    int rules_;
};

}  // namespace vvr::workers
