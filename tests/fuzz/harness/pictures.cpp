// Names that mean many pictures: frame%04d.png, *.png.
#include "core/video/input_files.h"
#include "tests/fuzz/folder.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    static const fuzz::Folder folder;
    const std::string name(fuzz::text_of(data, size));
    // Only names in the folder: others would have this look through the machine.
    if (name.find('/') != std::string::npos || name.find('\0') != std::string::npos || name == "..") return 0;
    for (const char* file : {"frame0001.png", "frame0002.png", "b%.png", "x.jpg"}) folder.write(file, "x");
    const auto list = fuzz::parsed([&] { return video::list_pictures((folder.path() / name).string()); });
    if (!list || !*list) return 0;
    for (const std::string& file : **list) fuzz::require(std::filesystem::exists(file), "what is listed is there");
    return 0;
}
