#include "cli/workers/sandbox.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <link.h>
#include <sys/auxv.h>
#include <sys/prctl.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/image/text.h"

namespace vvr::workers {

namespace {

namespace fs = std::filesystem;

struct Place {
    const char* path;
    Use use;
    bool gpu = false;  ///< only with a graphics card
};

constexpr std::array places{
    Place{"/proc/self/exe", Use::run},
    // Libraries, drivers, fonts, time zones, locales: readable by everybody anyway.
    Place{"/usr", Use::read},
    Place{"/lib", Use::read},
    Place{"/lib64", Use::read},
    Place{"/etc/ld.so.cache", Use::read},
    Place{"/etc/ld.so.preload", Use::read},
    Place{"/etc/fonts", Use::read},
    Place{"/etc/glvnd", Use::read},
    Place{"/etc/drirc", Use::read},
    Place{"/etc/localtime", Use::read},
    Place{"/proc/cpuinfo", Use::read},
    Place{"/proc/meminfo", Use::read},
    Place{"/proc/stat", Use::read},
    Place{"/proc/filesystems", Use::read},
    Place{"/proc/sys/vm", Use::read},
    Place{"/sys/devices/system", Use::read},
    Place{"/sys/kernel/mm", Use::read},
    Place{"/dev/null", Use::change},
    Place{"/dev/zero", Use::read},
    Place{"/dev/random", Use::read},
    Place{"/dev/urandom", Use::read},
    Place{"/sys", Use::read, true},
    Place{"/proc/driver", Use::read, true},
    Place{"/dev/dri", Use::device, true},
    Place{"/dev/kfd", Use::device, true},
};

/// Adds the folders in which the dynamic linker looks for libraries: LD_LIBRARY_PATH, the program's run path, the
/// system's.
void add_library_folders(std::vector<ProgramFile>& files) {
    void* const program = ::dlopen(nullptr, RTLD_LAZY);
    if (program == nullptr) return;
    Dl_serinfo head{};
    if (::dlinfo(program, RTLD_DI_SERINFOSIZE, &head) == 0) {
        const std::unique_ptr<std::byte[]> room(new std::byte[head.dls_size]);
        auto* const found = reinterpret_cast<Dl_serinfo*>(room.get());
        if (::dlinfo(program, RTLD_DI_SERINFOSIZE, found) == 0 && ::dlinfo(program, RTLD_DI_SERINFO, found) == 0) {
            for (unsigned i = 0; i < found->dls_cnt; ++i) {
                const fs::path folder = found->dls_serpath[i].dls_name;
                if (folder.is_absolute() && folder != folder.root_path()) files.push_back({folder, Use::read});
            }
        }
    }
    ::dlclose(program);
}

/// Adds the loaded libraries, wherever they are, including the dynamic linker, which must be executable.
void add_libraries(std::vector<ProgramFile>& files) {
    const auto add = [](dl_phdr_info* info, std::size_t, void* to) {
        const std::string_view name = info->dlpi_name;
        const bool linker = info->dlpi_addr == ::getauxval(AT_BASE);
        if (name.starts_with('/')) {
            static_cast<std::vector<ProgramFile>*>(to)->push_back({name, linker ? Use::run : Use::read});
        }
        return 0;
    };
    ::dl_iterate_phdr(add, &files);
}

/// Adds Mesa's shader cache of this user (gl/context.h). Other programs of the user run its contents, so a worker may
/// only read them; but Mesa must be able to write the cache's index.
void add_shader_cache(std::vector<ProgramFile>& files) {
    const char* const folder = std::getenv("MESA_SHADER_CACHE_DIR");
    if (folder == nullptr || !fs::path(folder).is_absolute()) return;
    const fs::path cache = fs::path(folder) / "mesa_shader_cache";
    files.push_back({cache, Use::read});
    files.push_back({cache / "index", Use::change});
}

/// Adds NVIDIA's numbered devices.
void add_nvidia(std::vector<ProgramFile>& files) {
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator("/dev", none)) {
        if (entry.path().filename().string().starts_with("nvidia")) files.push_back({entry.path(), Use::device});
    }
}

}  // namespace

std::vector<ProgramFile> program_files(bool gpu) {
    std::vector<ProgramFile> files;
    for (const Place& place : places) {
        if (gpu || !place.gpu) files.push_back({place.path, place.use});
    }
    if (gpu) add_nvidia(files);
    add_library_folders(files);
    add_libraries(files);
    add_shader_cache(files);
    for (const fs::path& place : image::font_places()) files.push_back({place, Use::read});
    return files;
}

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool watched = true;  // LeakSanitizer traces the process from another one, which a sandbox denies
#else
constexpr bool watched = false;
#endif

std::string landlock_error_text(const Landlock& landlock) {
    return fmt::format("this kernel has no Landlock ({}), so workers can use all files of this user",
                       text_of_system_error(landlock.error));
}

std::string seccomp_error_text(int error) {
    return fmt::format("this kernel has no seccomp filters ({}), so workers can use the network",
                       text_of_system_error(error));
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
        throw Error(ErrorCode::sandbox_unavailable,
                    fmt::format("--sandbox required is not possible: {}; use Linux 5.13 or later (in a container, its "
                                "runtime must allow it too), or --sandbox auto",
                                landlock_.abi == 0 ? landlock_error_text(landlock_) : seccomp_error_text(no_filter_)));
    }
    if (no_filter_ == 0) filter_ = std::make_unique<CallFilter>(needs.gpu);
    if (landlock_.abi == 0) return;
    shared_ = program_files(needs.gpu);
    for (const std::filesystem::path& file : needs.files) shared_.push_back({file, Use::read});
}

std::string Sandbox::summary() const {
    if (mode_ == SandboxMode::off) return "no sandbox: workers have all permissions of this user (--sandbox off)";
    if (landlock_.abi == 0 && no_filter_ != 0) {
        return fmt::format("no sandbox: {}; {}", landlock_error_text(landlock_), seccomp_error_text(no_filter_));
    }
    if (landlock_.abi == 0)
        return fmt::format("workers can't use the network (seccomp); {}", landlock_error_text(landlock_));
    const std::string walls =
        fmt::format("workers can only read their clips and write beside their pictures (Landlock {})", landlock_.abi);
    if (no_filter_ != 0) return fmt::format("{}; {}", walls, seccomp_error_text(no_filter_));
    return walls + ", and can't use the network (seccomp)";
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
