#include "cli/workers/sandbox.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/auxv.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

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

namespace {

// As in <linux/landlock.h>, whose older versions lack some of them.
namespace right {
constexpr std::uint64_t execute = 1 << 0;
constexpr std::uint64_t write_file = 1 << 1;
constexpr std::uint64_t read_file = 1 << 2;
constexpr std::uint64_t read_folder = 1 << 3;
constexpr std::uint64_t remove_file = 1 << 5;
constexpr std::uint64_t make_file = 1 << 8;
constexpr std::uint64_t truncate = 1 << 14;
constexpr std::uint64_t control_device = 1 << 15;
constexpr std::uint64_t of_a_file = execute | write_file | read_file | truncate | control_device;
}  // namespace right

struct Attributes {
    std::uint64_t files;
    std::uint64_t network;
    std::uint64_t scoped;
};

struct [[gnu::packed]] PathRule {
    std::uint64_t allowed;
    std::int32_t parent;
};

constexpr int path_rule = 1;
constexpr std::uint32_t ask_version = 1;

/// All that a version of the interface can deny. Versions after the last row deny nothing more that a worker needs
/// denied.
struct AbiRow {
    int abi;
    int file_rights;        ///< number of file rights
    std::uint64_t network;  ///< TCP: bind, connect
    std::uint64_t scoped;   ///< abstract UNIX sockets of, and signals to, other processes
    std::size_t size;       ///< of Attributes in that version
};

constexpr std::array abis{
    AbiRow{1, 13, 0, 0, 8},   // Linux 5.13
    AbiRow{2, 14, 0, 0, 8},   // 5.19: links and renames across folders
    AbiRow{3, 15, 0, 0, 8},   // 6.2: truncation
    AbiRow{4, 15, 3, 0, 16},  // 6.7: TCP
    AbiRow{5, 16, 3, 0, 16},  // 6.10: ioctl on devices
    AbiRow{6, 16, 3, 3, 24},  // 6.12: signals and abstract sockets
};

const AbiRow& row_of(int abi) {
    return abis.at(static_cast<std::size_t>(std::clamp<int>(abi, 1, abis.size())) - 1);
}

std::uint64_t file_rights_of(int abi) {
    return (std::uint64_t{1} << row_of(abi).file_rights) - 1;
}

struct UseRow {
    Use use;
    std::uint64_t rights;
};

constexpr std::array uses{
    UseRow{Use::read, right::read_file | right::read_folder},
    UseRow{Use::run, right::read_file | right::read_folder | right::execute},
    UseRow{Use::change, right::read_file | right::write_file},
    UseRow{Use::write, right::write_file | right::make_file | right::remove_file | right::truncate},
    UseRow{Use::device, right::read_file | right::read_folder | right::write_file | right::control_device},
};

}  // namespace

void refuse_sandbox(std::string_view what, int error) {
    throw Error(ErrorCode::worker_start_failed,
                fmt::format("cannot create the sandbox of a worker: {}: {}; try --sandbox off", what,
                            text_of_system_error(error)));
}

Landlock find_landlock() {
    const long abi = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, ask_version);
    return abi > 0 ? Landlock{static_cast<int>(abi), 0} : Landlock{0, errno};
}

LandlockRules::LandlockRules(int abi) : abi_(abi) {
    const AbiRow& row = row_of(abi);
    const Attributes attributes{file_rights_of(abi), row.network, row.scoped};
    rules_ = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, row.size, 0));
    if (rules_ < 0) refuse_sandbox("landlock_create_ruleset", errno);
}

LandlockRules::~LandlockRules() {
    ::close(rules_);
}

void LandlockRules::allow(const std::filesystem::path& path, Use use) {
    const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    if (file < 0) {
        // A file that is missing or that we can't access needs no rule. Other errors, such as too many open files, must
        // not silently leave out a clip.
        if (errno == ENOENT || errno == ENOTDIR || errno == EACCES || errno == ELOOP) return;
        refuse_sandbox(path.c_str(), errno);
    }
    struct stat status {};
    const bool is_folder = ::fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
    std::uint64_t rights = std::ranges::find(uses, use, &UseRow::use)->rights & file_rights_of(abi_);
    if (!is_folder) rights &= right::of_a_file;
    const PathRule rule{rights, file};
    const long added = ::syscall(SYS_landlock_add_rule, rules_, path_rule, &rule, 0);
    const int error = errno;
    ::close(file);
    if (added != 0) refuse_sandbox(path.c_str(), error);
}

bool LandlockRules::enforce() const {
    return ::syscall(SYS_landlock_restrict_self, rules_, 0) == 0;
}

}  // namespace vvr::workers
