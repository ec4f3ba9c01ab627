#include "cli/workers/sandbox.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/prctl.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::workers {

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool watched = true;  // LeakSanitizer looks at a process from another one, which a sandbox refuses
#else
constexpr bool watched = false;
#endif

std::string reason(int error) {
    return std::generic_category().message(error);
}

std::string landlock_error_text(const Landlock& landlock) {
    return fmt::format("this kernel has no Landlock ({}), by which files are kept from them", reason(landlock.error));
}

std::string seccomp_error_text(int error) {
    return fmt::format("this kernel has no seccomp filters ({}), by which the network is kept from them",
                       reason(error));
}

}  // namespace

Confinement::Confinement(std::unique_ptr<const LandlockRules> rules, const CallFilter* filter)
    : rules_(std::move(rules)), filter_(filter) {}

bool Confinement::enter() const {
    if (!rules_ && filter_ == nullptr) return true;
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && (!rules_ || rules_->enforce()) &&
           (filter_ == nullptr || filter_->enforce());
}

Sandbox::Sandbox(SandboxMode mode, const SandboxNeeds& needs)
    : mode_(watched && mode == SandboxMode::automatic ? SandboxMode::off : mode) {
    if (mode_ == SandboxMode::off) return;
    landlock_ = find_landlock();
    no_filter_ = call_filter_error();
    if (mode == SandboxMode::required && (landlock_.abi == 0 || no_filter_ != 0)) {
        throw Error(ErrorKind::backend,
                    fmt::format("workers can't be shut in, and --sandbox required asks for it: {}; use a kernel that "
                                "has it (Linux 5.13 or later, and in a container one that lets it through), or "
                                "--sandbox auto",
                                landlock_.abi == 0 ? landlock_error_text(landlock_) : seccomp_error_text(no_filter_)));
    }
    if (no_filter_ == 0) filter_ = std::make_unique<CallFilter>(needs.gpu);
    if (landlock_.abi == 0) return;
    shared_ = program_files(needs.gpu);
    for (const std::filesystem::path& file : needs.files) shared_.push_back({file, Use::read});
}

std::string Sandbox::summary() const {
    if (mode_ == SandboxMode::off) return "no sandbox: workers may do all that you may (--sandbox off)";
    if (landlock_.abi == 0 && no_filter_ != 0) {
        return fmt::format("no sandbox: {}; {}", landlock_error_text(landlock_), seccomp_error_text(no_filter_));
    }
    if (landlock_.abi == 0) return fmt::format("workers have no network (seccomp); {}", landlock_error_text(landlock_));
    const std::string walls = fmt::format(
        "workers read their clips and write beside their pictures alone "
        "(Landlock {})",
        landlock_.abi);
    if (no_filter_ != 0) return fmt::format("{}; {}", walls, seccomp_error_text(no_filter_));
    return walls + ", and have no network (seccomp)";
}

Confinement Sandbox::around(const std::vector<std::filesystem::path>& files,
                            const std::filesystem::path& folder) const {
    if (landlock_.abi == 0) return {nullptr, filter_.get()};
    auto rules = std::make_unique<LandlockRules>(landlock_.abi);
    for (const ProgramFile& file : shared_) rules->allow(file.path, file.use);
    for (const std::filesystem::path& file : files) rules->allow(file, Use::read);
    rules->allow(folder, Use::write);
    return {std::move(rules), filter_.get()};
}

}  // namespace vvr::workers
