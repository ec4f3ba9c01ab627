#include "core/fields/listed_seeds.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/fields/settings.h"

namespace vvr::fields {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t few_lists = 160;

std::vector<fs::path> lists_in(const std::string& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".txt") files.push_back(entry.path());
    }
    if (error) {
        throw Error(ErrorKind::io,
                    fmt::format("seeds: cannot read the folder '{}': {}; name a folder of lists, or one list", folder,
                                error.message()),
                    {setting::seeds.name});
    }
    if (files.empty()) {
        throw Error(ErrorKind::io,
                    fmt::format("seeds: '{}' holds no list of seeds (000000.txt); `vvr extract` writes them to a "
                                "folder 'seeds'",
                                folder),
                    {setting::seeds.name});
    }
    std::ranges::sort(files);
    return files;
}

/// Linear between the pixels about a point within the plane.
float value_at(const Plane<float>& plane, float x, float y) {
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int right = std::min(left + 1, plane.width() - 1);
    const int below = std::min(top + 1, plane.height() - 1);
    const float across = x - static_cast<float>(left);
    const float upper = std::lerp(plane.at(left, top), plane.at(right, top), across);
    return std::lerp(upper, std::lerp(plane.at(left, below), plane.at(right, below), across),
                     y - static_cast<float>(top));
}

}  // namespace

ListedSeeds::ListedSeeds(std::unique_ptr<FieldSource> fields, const std::string& path, const SeedOptions& options,
                         bool on_object)
    : fields_(std::move(fields)), min_magnitude_(options.min_magnitude), on_object_(on_object) {
    if (fs::is_regular_file(path)) {
        shared_ = read_seeds(path);
        check_size(*shared_, path);
        return;
    }
    for (const fs::path& file : lists_in(path)) {
        SeedList list = read_seeds(file.string());
        check_size(list, file.string());
        const std::int64_t frame = list.frame;
        if (!lists_.emplace(frame, std::move(list)).second) {
            throw Error(ErrorKind::io, fmt::format("{}: frame {} has a list already", file.string(), frame));
        }
    }
}

void ListedSeeds::check_size(const SeedList& list, const std::string& file) const {
    if (list.size == field_size()) return;
    throw Error(ErrorKind::io,
                fmt::format("{}: seeds of a field of {}x{}, but the clip's fields have {}x{}; change the "
                            "fields' size or the list",
                            file, list.size.width, list.size.height, field_size().width, field_size().height),
                {setting::field_size.name});
}

std::int64_t ListedSeeds::interval(std::int64_t asked) const {
    return fields_->interval(!shared_ && lists_.size() <= few_lists ? 1 : asked);
}

std::vector<Seed> ListedSeeds::shared_seeds(const Field& field) const {
    if (field.flow.u.empty()) {
        throw Error(ErrorKind::usage,
                    "seeds: a list that all frames share takes its directions from the flow of each, and none is "
                    "computed; choose another flow, or a folder with a list for each frame",
                    {setting::seeds.name, setting::flow.name});
    }
    std::vector<Seed> seeds;
    for (Seed seed : shared_->seeds) {
        const auto column = static_cast<int>(std::lround(seed.x));
        const auto row = static_cast<int>(std::lround(seed.y));
        if (on_object_ && field.scalar.at(column, row) == 0) continue;
        seed.u = value_at(field.flow.u, seed.x, seed.y);
        seed.v = value_at(field.flow.v, seed.x, seed.y);
        if (std::hypot(seed.u, seed.v) >= min_magnitude_) seeds.push_back(seed);
    }
    return seeds;
}

FieldSummary ListedSeeds::read(const FieldNeeds& needs, const FieldSink& sink) {
    FieldNeeds rest = needs;
    rest.seeds = false;
    rest.flow = needs.flow || (needs.seeds && shared_);
    return fields_->read(rest, [&](const video::SharedFrame& frame, Field&& field) {
        field.seeds.clear();
        const auto list = lists_.find(field.index);
        if (needs.seeds && list != lists_.end()) field.seeds = list->second.seeds;
        if (needs.seeds && shared_ && field.index % needs.every == 0) field.seeds = shared_seeds(field);
        sink(frame, std::move(field));
    });
}

}  // namespace vvr::fields
