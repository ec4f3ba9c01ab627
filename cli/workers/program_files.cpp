#include "cli/workers/program_files.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <link.h>
#include <sys/auxv.h>

#include "core/image/text.h"

namespace vvr::workers {

namespace {

namespace fs = std::filesystem;

struct Place {
    const char* path;
    Use use;
    bool gpu = false;  ///< for a graphics card alone
};

constexpr std::array places{
    Place{"/proc/self/exe", Use::run},
    // Libraries, drivers, fonts, time zones, locales: what is there is everybody's to read.
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

/// Where libraries are looked for, as the dynamic linker says: LD_LIBRARY_PATH, the program's own path, the system's.
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

/// The libraries that are loaded, wherever they come from; the linker among them, which is executed.
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

/// The cache of shaders that Mesa has for this user (gl/shader_cache.h). What it holds is run as it stands, by other
/// programs of the user too, so a worker only reads it; but Mesa wants to write the list of what is there.
void add_shader_cache(std::vector<ProgramFile>& files) {
    const char* const folder = std::getenv("MESA_SHADER_CACHE_DIR");
    if (folder == nullptr || !fs::path(folder).is_absolute()) return;
    const fs::path cache = fs::path(folder) / "mesa_shader_cache";
    files.push_back({cache, Use::read});
    files.push_back({cache / "index", Use::change});
}

/// NVIDIA's devices have numbers.
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

}  // namespace vvr::workers
