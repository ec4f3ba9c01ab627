#include "core/fields/listed_seeds.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/fields/settings.h"

namespace vvr {
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
        throw Error(ErrorKind::io, fmt::format("seeds: cannot read the folder '{}': {}", folder, error.message()),
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

}  // namespace

ListedSeeds::ListedSeeds(std::unique_ptr<FieldSource> fields, const std::string& folder) : fields_(std::move(fields)) {
    for (const fs::path& file : lists_in(folder)) {
        SeedList list = read_seeds(file.string());
        if (list.size != field_size()) {
            throw Error(
                ErrorKind::io,
                fmt::format("{}: seeds of a field of {}x{}, but the clip's fields have {}x{}; change the "
                            "fields' size or the list",
                            file.string(), list.size.width, list.size.height, field_size().width, field_size().height),
                {setting::field_size.name});
        }
        const std::int64_t frame = list.frame;
        if (!lists_.emplace(frame, std::move(list)).second) {
            throw Error(ErrorKind::io, fmt::format("{}: frame {} has a list already", file.string(), frame));
        }
    }
}

std::int64_t ListedSeeds::interval(std::int64_t asked) const {
    return fields_->interval(lists_.size() <= few_lists ? 1 : asked);
}

FieldSummary ListedSeeds::read(const FieldNeeds& needs, const FieldSink& sink) {
    FieldNeeds rest = needs;
    rest.seeds = false;
    return fields_->read(rest, [&](const SharedFrame& frame, Field&& field) {
        const auto list = lists_.find(field.index);
        field.seeds = needs.seeds && list != lists_.end() ? list->second.seeds : std::vector<Seed>{};
        sink(frame, std::move(field));
    });
}

}  // namespace vvr
