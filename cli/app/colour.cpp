#include "cli/app/colour.h"

#include "core/base/setting.h"
#include "core/fields/filter.h"

namespace vvr::app {

namespace {

std::vector<ColourRow> make_rows() {
    std::vector<ColourRow> rows{
        {"auto",
         "object if a part that describes objects is shown, the filter marks objects, and no transfer function is "
         "given; else transfer"},
        {"object", "each object its own; what is no object's is grey and faint", gl::VolumeColour::object},
        {"transfer", "the transfer function's, of the filter's values"},
        {"video", "the video's own", gl::VolumeColour::own, true},
        {"direction", "which way it moves, as a wheel of colours; grey where it rests", gl::VolumeColour::own, false,
         true, true},
        {"speed", "how fast it moves, as arrows have it", gl::VolumeColour::own, false, true},
        {"time", "the moment, from the first to the last", gl::VolumeColour::time},
    };
    for (const fields::FilterRow& filter : fields::filters()) {
        const std::string name(filter.name);
        rows.push_back({name, "a second filter's values: " + std::string(filter.help), gl::VolumeColour::own, false,
                        false, false, &filter});
    }
    return rows;
}

}  // namespace

const std::vector<ColourRow>& colour_rows() {
    static const std::vector<ColourRow> rows = make_rows();
    return rows;
}

const ColourRow& row_of(Name<ColourRow> name) {
    return choose("color", name.text, colour_rows());
}

}  // namespace vvr::app
