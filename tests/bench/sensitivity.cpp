// What each threshold of event detection does to a clip's events. Reads the clip once and prints the events as one line
// of JSON per variation: first with all thresholds as they are, then with each changed by a quarter, down and up.
//
// Usage: sensitivity CLIP
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/fields/field_source.h"
#include "core/footage/open_source.h"
#include "core/tracking/event_finder.h"
#include "core/tracking/event_options.h"

namespace vvr {
namespace {

using nlohmann::json;
using tracking::thresholds;

struct Threshold {
    std::string_view name;
    std::variant<int*, double*> value;
};

/// All single numbers of `Thresholds`, from its header.
const std::vector<Threshold>& table() {
    static const std::vector<Threshold> rows{
#include "threshold_table.inc"
    };
    return rows;
}

/// Changes a threshold by a factor, an integer by at least 1.
void change(const Threshold& threshold, double factor) {
    if (auto* const* real = std::get_if<double*>(&threshold.value)) {
        **real *= factor;
        return;
    }
    int& whole = *std::get<int*>(threshold.value);
    const int moved = static_cast<int>(std::lround(whole * factor));
    whole = moved == whole ? whole + (factor < 1 ? -1 : 1) : moved;
}

/// A clip's fields, read once.
struct Clip {
    struct Frame {
        media::SharedFrame frame;
        Plane<std::uint8_t> field;
        Moment at;
    };
    Size size;
    std::vector<Frame> frames;
    fields::Planes scene;
    double scale = 1;  ///< pixels of the clip per field pixel
};

Clip read(const std::string& name) {
    media::SourceOptions source{.colour = true};
    const auto opened = footage::open_source(name, source);
    fields::FieldOptions options;
    options.flow.method = "none";
    Clip clip;
    clip.size = opened->field_size();
    clip.scale = static_cast<double>(opened->info().size.width) / clip.size.width;
    fields::compute_fields(
        *opened, options,
        [&](const media::SharedFrame& frame, fields::Field&& field) {
            clip.frames.push_back({frame, std::move(field.scalar), {field.index, field.pts}});
        },
        [&](const fields::Reference& scene) {
            const fields::Planes& planes = scene;
            clip.scene = planes;
        });
    return clip;
}

/// In the form of the report of `vvr render`, of which it has what the measures need.
json events_of(const Clip& clip) {
    tracking::EventFinder finder(clip.size, {.labels = false});
    finder.set_scenes({clip.scene});
    for (const Clip::Frame& one : clip.frames) finder.add({one.field, one.frame->grey, one.frame->colour}, one.at);
    json all = json::array();
    const auto place = [&](double pixel) { return (pixel + 0.5) * clip.scale - 0.5; };
    for (const tracking::Event& event : finder.finish().events) {
        json path = json::array();
        for (const tracking::PathPoint& point : event.path) {
            path.push_back(
                {{"frame", point.at.frame}, {"place", {{"x", place(point.place.x)}, {"y", place(point.place.y)}}}});
        }
        const PixelBox& box = event.box;
        all.push_back({{"number", all.size() + 1},
                       {"kind", tracking::name_of(event.kind)},
                       {"first", {{"frame", event.first.frame}, {"seconds", event.first.seconds}}},
                       {"last", {{"frame", event.last.frame}, {"seconds", event.last.seconds}}},
                       {"box",
                        {{"x", box.left * clip.scale},
                         {"y", box.top * clip.scale},
                         {"width", box.width() * clip.scale},
                         {"height", box.height() * clip.scale}}},
                       {"path", std::move(path)}});
    }
    return all;
}

void print(std::string_view threshold, double factor, const Clip& clip) {
    const json line{{"threshold", threshold},
                    {"factor", factor},
                    {"seconds", clip.frames.empty() ? 0 : clip.frames.back().at.seconds},
                    {"events", events_of(clip)}};
    fmt::print("{}\n", line.dump());
    std::fflush(stdout);
}

void walk(const std::string& name) {
    const Clip clip = read(name);
    print("", 1, clip);
    for (const Threshold& threshold : table()) {
        for (const double factor : {0.75, 1.25}) {
            const tracking::Thresholds before = thresholds;
            change(threshold, factor);
            print(threshold.name, factor, clip);
            thresholds = before;
        }
    }
}

}  // namespace
}  // namespace vvr

int main(int count, char** arguments) {
    if (count != 2) {
        fmt::print(stderr, "usage: sensitivity CLIP\n");
        return 1;
    }
    try {
        vvr::walk(arguments[1]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "sensitivity: {}\n", error.what());
        return 1;
    }
    return 0;
}
