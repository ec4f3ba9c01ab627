#include "cli/app/used_settings.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/app/colour.h"
#include "cli/app/settings.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/scene/theme.h"

namespace vvr::app {

namespace {

/// The row that the settings name; null if they name none, or one that this version doesn't have.
template <class Rows>
auto row_of(const Rows& rows, const std::string& name) {
    const auto row = std::ranges::find(rows, name, [](const auto& one) { return std::string(one.name); });
    return row == std::ranges::end(rows) ? nullptr : &*row;
}

std::string threshold_of(const image::Metadata& settings) {
    const fields::FilterRow* const filter = row_of(fields::filters(), image::value_of(settings, setting::filter.name));
    return filter == nullptr ? "" : fmt::to_string(filter->traits.threshold);
}

template <auto Member>
std::string of_solver(const image::Metadata& settings) {
    const fields::SolverRow* const solver =
        row_of(fields::flow_solvers(), image::value_of(settings, setting::solver.name));
    return solver == nullptr ? "" : fmt::to_string(solver->defaults.*Member);
}

/// Empty if a second filter has its own transfer function: no single name describes both.
std::string transfer_of(const image::Metadata& settings) {
    const ColourRow* const colour = row_of(colour_rows(), image::value_of(settings, setting::colour.name));
    if (colour != nullptr && colour->filter != nullptr) return "";
    const fields::FilterRow* const filter = row_of(fields::filters(), image::value_of(settings, setting::filter.name));
    if (filter != nullptr && !filter->transfer.empty()) return std::string(filter->transfer);
    const scene::Theme* const theme = row_of(scene::themes(), image::value_of(settings, setting::theme.name));
    return theme == nullptr ? "" : std::string(theme->transfer);
}

/// A setting whose default value depends on another setting, and that value.
struct Decided {
    const Setting& setting;
    std::string (*value)(const image::Metadata& settings);
};

constexpr std::array decided{
    Decided{setting::threshold, threshold_of},
    Decided{setting::alpha, of_solver<&fields::SolverSettings::alpha>},
    Decided{setting::iterations, of_solver<&fields::SolverSettings::iterations>},
    Decided{setting::pre_smooth, of_solver<&fields::SolverSettings::pre_smooth>},
    Decided{setting::transfer, transfer_of},
    Decided{setting::seed_flags, [](const image::Metadata&) { return std::string(); }},
};

}  // namespace

image::Metadata used_settings(const image::Metadata& settings) {
    image::Metadata used;
    for (const auto& [name, value] : settings) {
        const auto row = std::ranges::find(decided, name, [](const Decided& one) { return one.setting.name; });
        const bool is_open = row != decided.end() && value == row->setting.default_text;
        std::string text = is_open ? row->value(settings) : value;
        if (!text.empty()) used.emplace_back(name, std::move(text));
    }
    return used;
}

}  // namespace vvr::app
