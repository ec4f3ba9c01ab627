// Names that mean many pictures: frame%04d.png, *.png.
#include "core/footage/input_files.h"
#include "tests/fuzz/input.h"
#include "tests/support/temp_folder.h"

void vvr::fuzz::check(std::string_view input) {
    static const test::TempFolder folder;
    const std::string name(input);
    // Only names in the folder: others would have this look through the machine.
    if (name.find('/') != std::string::npos || name.find('\0') != std::string::npos || name == "..") return;
    for (const char* file : {"frame0001.png", "frame0002.png", "b%.png", "x.jpg"})
        test::write_bytes(folder / file, "x");
    const auto list = parsed([&] { return footage::list_pictures(folder / name); });
    if (!list || !*list) return;
    for (const std::string& file : **list) require(std::filesystem::exists(file), "what is listed is there");
}
