// Names of a recorder's files: the first line is a pattern, the others are names.
#include <vector>

#include "core/video/recorder_names.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    std::string_view rest = fuzz::text_of(data, size);
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::vector<std::string> patterns{std::string(rest.substr(0, end))};
    auto names = fuzz::parsed([&] { return video::RecorderNames(patterns); });
    if (!names) names = video::RecorderNames();
    for (rest.remove_prefix(end); !rest.empty(); rest.remove_prefix(std::min(rest.find('\n', 1), rest.size()))) {
        const std::string_view name = rest.substr(0, std::min(rest.find('\n', 1), rest.size())).substr(1);
        const video::RecorderName read = names->read(name);
        fuzz::require(read.camera.size() <= name.size(), "a camera is a part of the name");
        if (read.begin) video::utc_of(*read.begin);
        names->camera_of(name);
    }
    return 0;
}
