// Names of a recorder's files: the first line is a pattern, the others are names.
#include <vector>

#include "core/footage/recorder_names.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view rest) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::vector<std::string> patterns{std::string(rest.substr(0, end))};
    auto names = parsed([&] { return footage::RecorderNames(patterns); });
    if (!names) names = footage::RecorderNames();
    for (rest.remove_prefix(end); !rest.empty(); rest.remove_prefix(std::min(rest.find('\n', 1), rest.size()))) {
        const std::string_view name = rest.substr(0, std::min(rest.find('\n', 1), rest.size())).substr(1);
        const footage::RecorderName read = names->read(name);
        require(read.camera.size() <= name.size(), "a camera is a part of the name");
        if (read.begin) footage::utc_of(*read.begin);
        names->camera_of(name);
    }
}
