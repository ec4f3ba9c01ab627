// Claims that somebody else left in a folder of pictures: whatever they hold, nothing outside is touched.
#include <fmt/format.h>

#include "core/archive/prune.h"
#include "core/base/digest.h"
#include "core/base/file.h"
#include "core/base/lock_file.h"
#include "tests/fuzz/input.h"
#include "tests/support/temp_folder.h"

void vvr::fuzz::check(std::string_view input) {
    static const test::TempFolder folder;
    const std::string name(input);
    const std::string pictures = folder / "pictures";
    std::filesystem::create_directories(pictures);
    for (const char* file : {"victim.png", "victim.html", "pictures/index.html"}) test::write_bytes(folder / file, "");
    const std::string lock = folder / fmt::format("pictures/.vvr-{:016x}.lock", fnv1a(name));
    test::write_bytes(lock, name);
    if (const auto claim = LockFile::take_over(lock)) {
        require(is_plain_name(claim->second), "a claim is for a plain name");
    }
    test::write_bytes(lock, name);
    archive::tidy(pictures, archive::list_outputs(pictures, folder / "none"));
    for (const char* file : {"victim.png", "victim.html", "pictures/index.html"}) {
        require(std::filesystem::exists(folder / file), "files of others stay");
    }
    std::filesystem::remove_all(pictures);
}
