#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/workers/confine.h"
#include "core/base/error.h"

namespace vvr::workers {

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
