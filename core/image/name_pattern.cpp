#include "core/image/name_pattern.h"

#include <algorithm>
#include <regex>
#include <vector>

#include <climits>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text.h"

namespace vvr::image {

namespace {

const std::vector<std::string>& counted_things() {
    static const std::vector<std::string> names = {"frame", "brick"};
    return names;
}

// {word:digits} with any word, so that unknown words are reported; a run of #; %d.
const std::regex& field() {
    static const std::regex expression(R"(\{([^{}:]*)(?::([^{}]*))?\}|(##+)|%(?:0([1-9]))?d)");
    return expression;
}

int digits_of(const std::string& text, const std::string& given) {
    if (text.size() == 1 && text[0] >= '1' && text[0] <= '9') return text[0] - '0';
    throw Error(ErrorCode::name_pattern_invalid,
                fmt::format("the field '{}' is invalid; give 1 to 9 digits, as in {{frame:4}}", given));
}

}  // namespace

NamePattern::NamePattern(const std::filesystem::path& path) : path_(path) {
    const std::string name = path.filename().string();
    // std::regex recurses for each character.
    if (name.size() > NAME_MAX) {
        throw Error(ErrorCode::name_pattern_invalid,
                    fmt::format("the file name '{}...' has {} bytes; use at most {} bytes", name.substr(0, 40),
                                name.size(), NAME_MAX));
    }
    std::smatch match;
    if (!std::regex_search(name, match, field())) return;
    has_field_ = true;
    before_ = match.prefix();
    after_ = match.suffix();
    if (std::regex_search(after_, field())) {
        throw Error(ErrorCode::name_pattern_invalid,
                    fmt::format("the file name '{}' has more than one number field; use one", path.string()));
    }
    const std::string given = match[0];
    if (given.front() == '#') {
        digits_ = static_cast<int>(given.size());
    } else if (given.front() == '%') {
        digits_ = match[4].matched ? digits_of(match[4], given) : 1;
    } else {
        counts_ = match[1];
        if (std::ranges::count(counted_things(), counts_) == 0) {
            throw Error(ErrorCode::name_pattern_invalid,
                        fmt::format("the field '{}' in '{}' is unknown{}; use {{frame:4}}, {{brick:4}}, #### or %04d",
                                    given, path.string(), did_you_mean(counts_, counted_things())));
        }
        digits_ = match[2].matched ? digits_of(match[2], given) : 1;
    }
}

NamePattern NamePattern::literal(const std::filesystem::path& path) {
    NamePattern name;
    name.path_ = path;
    return name;
}

bool NamePattern::may_be(const std::string& file) const {
    if (!has_field_) return file == path_.filename().string();
    if (!file.starts_with(before_) || !file.ends_with(after_)) return false;
    if (file.size() < before_.size() + after_.size() + static_cast<std::size_t>(digits_)) return false;
    return std::all_of(file.begin() + static_cast<std::ptrdiff_t>(before_.size()),
                       file.end() - static_cast<std::ptrdiff_t>(after_.size()), is_digit);
}

std::filesystem::path NamePattern::at(std::int64_t number) const {
    if (!has_field_) return path_;
    return path_.parent_path() / fmt::format("{}{:0{}}{}", before_, number, digits_, after_);
}

}  // namespace vvr::image
