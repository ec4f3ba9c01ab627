#include "core/fields/seed_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/fields/settings.h"

namespace vvr::fields {
namespace {

constexpr std::string_view first_line = "vvr-seeds 1";
constexpr int largest_side = 65536;

/// The lines of a text, without empty lines and comments, split into words.
class Lines {
  public:
    Lines(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    bool next() {
        while (!text_.empty()) {
            ++number_;
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            std::string_view line = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            if (line.ends_with('\r')) line.remove_suffix(1);
            line_ = line;
            split();
            if (!words_.empty() && !words_.front().starts_with('#')) return true;
        }
        ++number_;
        words_.clear();
        return false;
    }

    const std::vector<std::string_view>& words() const { return words_; }
    std::string_view line() const { return line_; }

    template <class Number>
    Number number(std::size_t word) const {
        Number value{};
        const std::string_view text = words_[word];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) fail(fmt::format("'{}' is not a number", text));
        return value;
    }

    float finite(std::size_t word) const {
        const auto value = number<float>(word);
        if (!std::isfinite(value)) fail(fmt::format("'{}' is not a finite number", words_[word]));
        return value;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("{}:{}: {}; docs/formats.md describes seed lists", name_, number_, what));
    }

  private:
    void split() {
        words_.clear();
        std::size_t at = 0;
        while ((at = line_.find_first_not_of(" \t", at)) != std::string_view::npos) {
            const std::size_t end = std::min(line_.find_first_of(" \t", at), line_.size());
            words_.push_back(line_.substr(at, end - at));
            at = end;
        }
    }

    std::string_view text_;
    std::string name_;
    std::string_view line_;
    std::vector<std::string_view> words_;
    int number_ = 0;
};

void expect(Lines& lines, std::string_view keyword, std::size_t numbers) {
    if (!lines.next()) lines.fail(fmt::format("expected a line '{} ...', found the end of the file", keyword));
    if (lines.words().front() != keyword || lines.words().size() != numbers + 1) {
        lines.fail(fmt::format("expected '{}' and {} number{}, found '{}'", keyword, numbers, numbers == 1 ? "" : "s",
                               lines.line()));
    }
}

Seed parse_point(const Lines& lines, Size size) {
    if (lines.words().size() != 5) {
        lines.fail(fmt::format("expected a point 'x y u v flag', found '{}'", lines.line()));
    }
    Seed seed{lines.finite(0), lines.finite(1), lines.finite(2), lines.finite(3)};
    const auto right = static_cast<float>(size.width - 1);
    const auto bottom = static_cast<float>(size.height - 1);
    if (seed.x < 0 || seed.y < 0 || seed.x > right || seed.y > bottom) {
        lines.fail(
            fmt::format("the point {}, {} lies outside the field of {}x{}", seed.x, seed.y, size.width, size.height));
    }
    const std::string_view flag = lines.words()[4];
    const std::optional<SeedFlags> flags = SeedFlags::parse(flag);
    if (!flags) {
        lines.fail(fmt::format("expected a flag of 1 to {} digits, each 0 or 1, found '{}'", SeedFlags::most, flag));
    }
    seed.flags = *flags;
    return seed;
}

}  // namespace

std::string format_seeds(const SeedList& list) {
    std::string text = fmt::format("{}\nframe {}\nsize {} {}\npoints {}\n# x y u v flag\n", first_line, list.frame,
                                   list.size.width, list.size.height, list.seeds.size());
    for (const Seed& s : list.seeds) {
        fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", s.x, s.y, s.u, s.v, s.flags.text());
    }
    return text;
}

SeedList parse_seeds(std::string_view text, const std::string& name) {
    Lines lines(text, name);
    if (!lines.next() || lines.line() != first_line)
        lines.fail(fmt::format("expected the first line '{}'", first_line));
    SeedList list;
    expect(lines, "frame", 1);
    list.frame = lines.number<std::int64_t>(1);
    expect(lines, "size", 2);
    list.size = {lines.number<int>(1), lines.number<int>(2)};
    if (list.size.width < 1 || list.size.height < 1 || list.size.width > largest_side ||
        list.size.height > largest_side) {
        lines.fail(fmt::format("a field has sides of 1 to {} pixels, found {}x{}", largest_side, list.size.width,
                               list.size.height));
    }
    expect(lines, "points", 1);
    const auto points = lines.number<std::uint64_t>(1);
    while (list.seeds.size() < points) {
        if (!lines.next()) lines.fail(fmt::format("the file ends after {} of {} points", list.seeds.size(), points));
        list.seeds.push_back(parse_point(lines, list.size));
    }
    if (lines.next()) lines.fail(fmt::format("there are more points than 'points {}' says", points));
    return list;
}

SeedList read_seeds(const std::string& path) {
    return parse_seeds(read_file(path), path);
}

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
        throw Error(code_of_system_error(error.value()),
                    fmt::format("seeds: cannot read the folder '{}': {}; give a folder of seed lists, or one list",
                                folder, error.message()),
                    {setting::seeds.name});
    }
    if (files.empty()) {
        throw Error(ErrorCode::file_not_found,
                    fmt::format("seeds: the folder '{}' has no seed list (000000.txt); give the folder 'seeds' of an "
                                "extraction",
                                folder),
                    {setting::seeds.name});
    }
    std::ranges::sort(files);
    return files;
}

/// Lists have as many digits as needed, but others may round them.
constexpr float rounding = 1e-3F;

/// The value at a point within the plane, by bilinear interpolation.
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

const Seed* misfit(const std::vector<Seed>& seeds, const Flow& flow) {
    const auto differs = [](float a, float b) { return !(std::abs(a - b) <= rounding * (1 + std::abs(a))); };
    const auto seed = std::ranges::find_if(seeds, [&](const Seed& s) {
        return differs(s.u, value_at(flow.u, s.x, s.y)) || differs(s.v, value_at(flow.v, s.x, s.y));
    });
    return seed == seeds.end() ? nullptr : &*seed;
}

ListedSeeds::ListedSeeds(std::unique_ptr<FieldSource> fields, const std::string& path, const SeedOptions& options,
                         bool on_object, bool compares)
    : fields_(std::move(fields)),
      min_magnitude_(options.min_magnitude),
      on_object_(on_object),
      compares_(compares),
      path_(path) {
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
            throw Error(ErrorCode::file_invalid,
                        fmt::format("{}: another list is for frame {} too; remove one of them", file.string(), frame));
        }
    }
}

void ListedSeeds::check_size(const SeedList& list, const std::string& file) const {
    if (list.size == field_size()) return;
    throw Error(ErrorCode::file_invalid,
                fmt::format("{}: the list is for a field of {}x{}, but the clip's fields are {}x{}; change the field "
                            "size or the list",
                            file, list.size.width, list.size.height, field_size().width, field_size().height),
                {setting::field_size.name});
}

std::int64_t ListedSeeds::interval(std::int64_t asked) const {
    return fields_->interval(!shared_ && lists_.size() <= few_lists ? 1 : asked);
}

std::vector<Seed> ListedSeeds::shared_seeds(const Field& field) const {
    if (field.flow.u.empty()) {
        throw Error(ErrorCode::options_conflict,
                    "seeds: a list for all frames needs the flow of each frame, but none is computed; choose a flow "
                    "method, or give a folder with a list for each frame",
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
    rest.flow = needs.flow || (needs.seeds && (shared_ || compares_));
    std::int64_t misfits = 0;
    std::int64_t first = 0;
    FieldSummary summary = fields_->read(rest, [&](const media::SharedFrame& frame, Field&& field) {
        field.seeds.clear();
        const auto list = lists_.find(field.index);
        if (needs.seeds && list != lists_.end()) {
            field.seeds = list->second.seeds;
            if (compares_ && !field.flow.u.empty() && misfit(field.seeds, field.flow) && misfits++ == 0)
                first = field.index;
        }
        if (needs.seeds && shared_ && field.index % needs.every == 0) field.seeds = shared_seeds(field);
        sink(frame, std::move(field));
    });
    if (misfits > 0) {
        summary.problems.push_back(fmt::format(
            "'{}': the seeds of {}, the first of them {}, have another flow than '{}', and arrows show that of the "
            "seeds; for seeds of this flow, run `vvr seeds {} -o LISTS` and give --seeds LISTS",
            path_, counted(misfits, "frame"), first, info().name, info().name));
    }
    return summary;
}

}  // namespace vvr::fields
