// The events of a clip, with other thresholds and weights. Each line on stdin is a trial, as JSON: {"thresholds":
// {"link.seconds": 0.75}, "weights": [bias, weight of each sign]}, where thresholds are factors, and what is left out
// is as it is. Reads the clip once for all trials, and prints a line for each, in the form of the report of `vvr
// render`, of which it has what the measures need.
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
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

using json = nlohmann::ordered_json;  // signs in their order

/// All single numbers of the thresholds.
std::map<std::string_view, std::variant<int*, double*>> numbers_of(tracking::Thresholds& thresholds) {
    return {
#include "threshold_table.inc"
    };
}

void change(double& number, double factor) {
    number *= factor;
}
void change(int& number, double factor) {
    number = static_cast<int>(std::lround(number * factor));
}

struct Trial {
    tracking::Thresholds thresholds = tracking::thresholds;
    double bias = tracking::sign_bias;
    decltype(tracking::sign_table) signs = tracking::sign_table;
    std::optional<tracking::EventFinder> finder{};
};

Trial read_trial(const json& asked) {
    Trial trial;
    const auto numbers = numbers_of(trial.thresholds);
    const json factors = asked.value("thresholds", json::object());
    for (const auto& [name, factor] : factors.items())
        std::visit([by = factor.get<double>()](auto* number) { change(*number, by); }, numbers.at(name));
    if (const auto weights = asked.find("weights"); weights != asked.end()) {
        trial.bias = weights->at(0);
        for (std::size_t k = 0; k < trial.signs.size(); ++k) trial.signs[k].weight = weights->at(k + 1);
    }
    return trial;
}

/// Where it is in the clip.
/// \param scale pixels of the clip per field pixel
json json_of(const PixelBox& box, double scale) {
    return {{"x", box.left * scale},
            {"y", box.top * scale},
            {"width", box.width() * scale},
            {"height", box.height() * scale}};
}

json json_of(const Moment& at) {
    return {{"frame", at.frame}, {"seconds", at.seconds}};
}

/// An event or a change.
template <class Found>
json json_of(const Found& found, double scale) {
    json one{{"first", json_of(found.first)}, {"last", json_of(found.last)}, {"box", json_of(found.box, scale)}};
    for (std::size_t k = 0; k < found.signs.size(); ++k)
        one["signs"][std::string(tracking::sign_table[k].name)] = found.signs[k];
    if constexpr (requires { found.kind; }) {
        one["kind"] = tracking::name_of(found.kind);
        for (const auto& [at, place] : found.path) {
            const glm::dvec2 there = (place + 0.5) * scale - 0.5;
            one["path"].push_back({{"frame", at.frame}, {"place", {{"x", there.x}, {"y", there.y}}}});
        }
    }
    return one;
}

json list_of(const auto& all, double scale) {
    json list = json::array();
    for (const auto& one : all) list.push_back(json_of(one, scale));
    return list;
}

void run(const std::string& name) {
    std::vector<Trial> trials;
    for (std::string line; std::getline(std::cin, line);) trials.push_back(read_trial(json::parse(line)));
    const auto each = [&](const auto& act) {
        for (Trial& trial : trials) {
            tracking::thresholds = trial.thresholds;
            tracking::sign_bias = trial.bias;
            tracking::sign_table = trial.signs;
            act(trial.finder);
        }
    };
    const auto clip = footage::open_source(name, {.colour = true});
    each([&](auto& finder) { finder.emplace(clip->field_size(), tracking::EventOptions{.labels = false}); });
    fields::FieldOptions options;
    options.flow.method = "none";
    Moment now;
    fields::compute_fields(
        *clip, options,
        [&](const media::SharedFrame& frame, const fields::Field& field) {
            const bool doubtful = frame->damaged || field.other_light > 0;
            const tracking::FrameView view{field.scalar, frame->grey, frame->colour,
                                           field.view,   doubtful,    field.scene.get()};
            now = {field.index, field.pts};
            each([&](auto& finder) { finder->add(view, now); });
        },
        [&](const fields::Reference& scene) {
            std::vector<fields::Planes> scenes;
            for (std::size_t k = 0; k <= scene.others.size(); ++k) scenes.push_back(scene.of_view(k).planes());
            each([&](auto& finder) { finder->set_scenes(scenes); });
        });
    const double scale = static_cast<double>(clip->info().size.width) / clip->field_size().width;
    each([&](auto& finder) {
        const tracking::Findings found = finder->finish();
        const json line{{"span", {{"last", now.seconds}}},
                        {"events", list_of(found.events, scale)},
                        {"changes", list_of(found.changes, scale)}};
        fmt::print("{}\n", line.dump());
    });
}

}  // namespace
}  // namespace vvr

int main(int count, char** arguments) try {
    vvr::run(count == 2 ? arguments[1] : throw std::invalid_argument("usage: events CLIP < TRIALS"));
} catch (const std::exception& error) {
    fmt::print(stderr, "events: {}\n", error.what());
    return 1;
}
