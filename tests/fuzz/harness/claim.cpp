// Claims that somebody else left in a folder of pictures: whatever they hold, nothing outside is touched.
#include <fmt/format.h>

#include "core/archive/lock_file.h"
#include "core/archive/prune.h"
#include "core/base/digest.h"
#include "core/base/file.h"
#include "tests/fuzz/folder.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    static const fuzz::Folder folder;
    const std::string name(fuzz::text_of(data, size));
    const auto pictures = folder.path() / "pictures";
    std::filesystem::create_directories(pictures);
    for (const char* file : {"victim.png", "victim.html", "pictures/index.html"}) folder.write(file, "");
    const auto lock = std::filesystem::path("pictures") / fmt::format(".vvr-{:016x}.lock", fnv1a(name));
    folder.write(lock, name);
    if (const auto claim = archive::LockFile::take_over(folder.path() / lock)) {
        fuzz::require(is_plain_name(claim->second), "a claim is for a plain name");
    }
    folder.write(lock, name);
    archive::tidy(pictures, archive::list_outputs(pictures, folder.path() / "none"));
    for (const char* file : {"victim.png", "victim.html", "pictures/index.html"}) {
        fuzz::require(std::filesystem::exists(folder.path() / file), "files of others stay");
    }
    std::filesystem::remove_all(pictures);
    return 0;
}
