#include <algorithm>
#include <charconv>
#include <chrono>

#include <re2/re2.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/video/pattern_set.h"
#include "core/video/recorder_names.h"

namespace vvr::video {

namespace {

struct FieldRow {
    std::string_view name;
    NameField field;
    std::string_view expression;  ///< without capturing groups
    std::string_view loose = {};  ///< matches at least the same, and is much smaller; empty = none
};

constexpr std::array fields{
    FieldRow{"*", NameField::text, "[^/]*?"},
    FieldRow{"?", NameField::text, "[^/]"},
    FieldRow{"{camera}", NameField::camera, "[^/]+?"},
    FieldRow{"{number}", NameField::number, "[0-9]{1,18}"},
    FieldRow{"%Y", NameField::year, "19[7-9][0-9]|2[01][0-9][0-9]"},
    FieldRow{"%y", NameField::year_of_century, "[0-9][0-9]"},
    FieldRow{"%m", NameField::month, "0[1-9]|1[0-2]"},
    FieldRow{"%-m", NameField::month, "0[1-9]|1[0-2]|[1-9]"},
    FieldRow{"%d", NameField::day, "0[1-9]|[12][0-9]|3[01]"},
    FieldRow{"%-d", NameField::day, "0[1-9]|[12][0-9]|3[01]|[1-9]"},
    FieldRow{"%H", NameField::hour, "[01][0-9]|2[0-3]"},
    FieldRow{"%-H", NameField::hour, "[01][0-9]|2[0-3]|[0-9]"},
    FieldRow{"%M", NameField::minute, "[0-5][0-9]"},
    FieldRow{"%S", NameField::second, "[0-5][0-9]|60"},
    FieldRow{"%s", NameField::epoch, "[0-9]{9,11}"},
    FieldRow{"%z", NameField::zone, "Z|[-+](?:0[0-9]|1[0-4])[0-5][0-9]|[-+](?:0[0-9]|1[0-4]|[0-9])(?::[0-5][0-9])?"},
};

// Further fields for the patterns of known recorders. An expression with `%` or `{` consists of other fields.
constexpr std::array internal_fields{
    // A date. 03-04-2026 is not accepted, because day and month are ambiguous.
    FieldRow{"{date}", NameField::text, "%Y-%m-%d|%Y_%m_%d|%Y\\.%m\\.%d|%Y%m%d",
             "[0-9]{4}[-_.]?[0-9]{2}[-_.]?[0-9]{2}"},
    FieldRow{"{dated}", NameField::text, "{date}|%Y/%m/%d|%Y-%m/%d|%Y/%m-%d|%Y/%m/{date}|%Y/{date}|%Y/%Y-%m/{date}",
             "[0-9]{4}[-_./0-9]*[0-9]{2}"},
    // A time with seconds, with or without separators, and a time without seconds.
    FieldRow{"{time}", NameField::text, "%H-%M-%S|%H\\.%M\\.%S|%H_%M_%S|%H:%M:%S|%Hh%Mm%Ss?"},
    FieldRow{"{clock}", NameField::text, "{time}|%H%M%S(?:[0-9]{3})?"},
    FieldRow{"{minute}", NameField::text, "%H-%M|%H\\.%M|%H_%M|%H:%M|%Hh%Mm?|%H%M"},
    FieldRow{"{moment}", NameField::text, "{date}{join}{clock}|{date}{clock}"},
    FieldRow{"{join}", NameField::text, "[-_. T@]|_-_| - | at |, |--|__"},
    FieldRow{"{gap}", NameField::text, "[-_. ]{1,3}| at "},
    FieldRow{"{fraction}", NameField::text, "(?:[.,][0-9]{1,9})?"},
    FieldRow{"{zone}", NameField::zone, "Z|[+](?:0[0-9]|1[0-4])(?::?[0-5][0-9])?|-(?:0[0-9]|1[0-4]):[0-5][0-9]"},
    // What may follow: nothing, or text that doesn't continue the number.
    FieldRow{"{more}", NameField::text, "(?:[^0-9/][^/]*)?"},
    FieldRow{"{set off}", NameField::text, "(?:[^0-9A-Za-z/][^/]*)?"},
    FieldRow{"{until}", NameField::text,
             "(?:[-_ ]{1,3}(?:to[-_ ])?(?:[0-9]{4}[-_.]?[0-9]{2}[-_.]?[0-9]{2}[-_ T])?[0-9]{2}[-._:h]?[0-9]{2})?"},
    FieldRow{"{before}", NameField::text, "[^/]*[^0-9/]"},
    FieldRow{"{hour}", NameField::hour, "[01][0-9]|2[0-3]"},
    FieldRow{"{named}", NameField::camera, "[^/]*[^0-9/][^/]*"},
    FieldRow{"{side}", NameField::camera,
             "(?i:(?:cam|camera|ch|channel)[-_ ]?[0-9]{1,3}|front|back|rear|left|right|left_repeater|right_repeater|"
             "left_pillar|right_pillar)"},
    FieldRow{"{unsure date}", NameField::text,
             "(?:[^/]*[^-_. 0-9/][-_. ]{0,3})?[0-9]{1,2}[-._ ][0-9]{1,2}[-._ ](?:19|20)[0-9]{2}[^0-9][^/]*"},
    FieldRow{"{epoch}", NameField::epoch, "1[0-9]{9}|2[01][0-9]{8}"},
    FieldRow{"{epoch ms}", NameField::epoch_ms, "1[0-9]{12}|2[01][0-9]{11}"},
    FieldRow{"{until epoch}", NameField::text, "(?:[-_ ][12][0-9]{9}|[-_ ][12][0-9]{12})?"},
};

constexpr std::size_t longest_pattern = 255;
constexpr std::size_t longest_path = 4096;

[[noreturn]] void refuse(std::string_view pattern, std::string_view why) {
    throw Error(ErrorCode::name_pattern_invalid,
                fmt::format("'{}' is not a pattern of file names: {}; an example is Frigate's "
                            "'%Y-%m-%d/%H/{{camera}}/%M.%S'",
                            pattern, why),
                {"names"});
}

/// The row whose name is a prefix of `text`, or null.
template <class Rows>
const FieldRow* row_at(const Rows& rows, std::string_view text) {
    const auto found = std::ranges::find_if(rows, [&](const FieldRow& row) { return text.starts_with(row.name); });
    return found == std::end(rows) ? nullptr : &*found;
}

/// Builds a regular expression.
struct ExpressionBuilder {
    bool loose = false;
    std::string expression{};
    std::vector<NameField> captures{};

    /// Adds a row's expression, and replaces the fields in it. The rest is RE2 syntax.
    void add_words(std::string_view expression_of_row) {
        for (std::string_view rest = expression_of_row; !rest.empty();) {
            const bool word = rest.front() == '%' || (rest.front() == '{' && rest.size() > 1 && rest[1] >= 'a');
            if (const FieldRow* row = word ? row_of(rest) : nullptr) {
                add(*row);
                rest.remove_prefix(row->name.size());
                continue;
            }
            expression += rest.front();
            rest.remove_prefix(1);
        }
    }

    void add(const FieldRow& row) {
        const bool captured = row.field != NameField::text;
        if (captured) captures.push_back(row.field);
        expression += captured ? "(" : "(?:";
        add_words(loose && !row.loose.empty() ? row.loose : row.expression);
        expression += ")";
    }

    static const FieldRow* row_of(std::string_view text) {
        const FieldRow* own = row_at(internal_fields, text);
        return own != nullptr ? own : row_at(fields, text);
    }

    bool has(NameField field) const { return std::ranges::count(captures, field) > 0; }
};

ExpressionBuilder make(std::string_view pattern, RecorderPattern::Words words, bool loose = false) {
    ExpressionBuilder builder{.loose = loose, .expression = "(?:.*/)?"};
    for (std::string_view rest = pattern; !rest.empty();) {
        const FieldRow* row =
            words == RecorderPattern::Words::fields_and_own ? ExpressionBuilder::row_of(rest) : row_at(fields, rest);
        if (row != nullptr) {
            builder.add(*row);
            rest.remove_prefix(row->name.size());
            continue;
        }
        const bool percent = rest.starts_with("%%");
        if (!percent && (rest.front() == '%' || rest.front() == '{')) {
            const std::size_t end = rest.front() == '%' ? 2 : std::min(rest.find('}'), rest.size() - 1) + 1;
            refuse(pattern, fmt::format("unknown field '{}' (known: {})", rest.substr(0, end),
                                        fmt::join(names_of(fields), " ")));
        }
        builder.expression += re2::RE2::QuoteMeta(re2::StringPiece(rest.data(), 1));
        rest.remove_prefix(percent ? 2 : 1);
    }
    return builder;
}

std::int64_t number_in(std::string_view digits) {
    std::int64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// Parses "Z", "+1", "+01:00" or "-0330" as an offset from UTC in seconds.
std::int64_t zone_in(std::string_view text) {
    if (text == "Z") return 0;
    const bool west = text.front() == '-';
    text.remove_prefix(1);
    const std::size_t hours = std::min<std::size_t>(std::min(text.find(':'), text.size()), 2);
    std::int64_t ahead = number_in(text.substr(0, hours)) * 3600;
    if (text.size() > 2) ahead += number_in(text.substr(text.size() - 2)) * 60;
    return west ? -ahead : ahead;
}

std::int64_t value_of(NameField field, std::string_view text) {
    return field == NameField::zone ? zone_in(text) : number_in(text);
}

}  // namespace

std::optional<NamedTime> NameFields::time(bool utc) const {
    const NameFields& name = *this;
    if (const auto epoch = name[NameField::epoch]) return NamedTime{*epoch, 0};
    if (const auto epoch = name[NameField::epoch_ms]) return NamedTime{*epoch / 1000, 0};
    const auto hour = name[NameField::hour];
    if (!hour) return std::nullopt;
    const std::optional<std::int64_t> of_century = name[NameField::year_of_century];
    const std::int64_t year = of_century ? 2000 + *of_century : name[NameField::year].value_or(0);
    const std::chrono::year_month_day date{
        std::chrono::year(static_cast<int>(year)),
        std::chrono::month(static_cast<unsigned>(name[NameField::month].value_or(0))),
        std::chrono::day(static_cast<unsigned>(name[NameField::day].value_or(0)))};
    if (!date.ok()) return std::nullopt;
    const std::chrono::sys_seconds midnight = std::chrono::sys_days(date);
    NamedTime time{midnight.time_since_epoch().count() + *hour * 3600 + name[NameField::minute].value_or(0) * 60 +
                       name[NameField::second].value_or(0),
                   name[NameField::zone]};
    if (!time.ahead && utc) time.ahead = 0;
    return time;
}

RecorderPattern::RecorderPattern(std::string_view pattern, Words words) {
    if (pattern.empty() || (words == Words::fields && pattern.size() > longest_pattern)) {
        refuse(pattern, fmt::format("it has {} bytes, not 1 to {}", pattern.size(), longest_pattern));
    }
    ExpressionBuilder builder = make(pattern, words);
    const auto has = [&](NameField field) { return builder.has(field); };
    const bool day =
        (has(NameField::year) || has(NameField::year_of_century)) && has(NameField::month) && has(NameField::day);
    const bool partly = day || has(NameField::hour) || has(NameField::month) || has(NameField::day);
    const bool whole = has(NameField::epoch) || has(NameField::epoch_ms) || (day && has(NameField::hour));
    if (words == Words::fields) {
        if (partly && !whole) refuse(pattern, "a time needs %Y, %m, %d and %H, or %s");
        if (!whole && !has(NameField::camera)) refuse(pattern, "it has neither {camera} nor a time");
    }
    auto expression = std::make_shared<re2::RE2>(builder.expression, name_options());
    if (!expression->ok()) refuse(pattern, fmt::format("it is too long ({})", expression->error()));
    expression_ = std::move(expression);
    captures_ = std::move(builder.captures);
}

std::string RecorderPattern::loose_expression(std::string_view pattern) {
    return make(pattern, Words::fields_and_own, true).expression;
}

std::optional<NameFields> RecorderPattern::read(std::string_view path) const {
    if (path.size() > longest_path) return std::nullopt;
    const re2::StringPiece text(path.data(), path.size());
    // Most names don't match. Matching without groups is much faster, so it comes first.
    if (!expression_->Match(text, 0, text.size(), re2::RE2::ANCHOR_BOTH, nullptr, 0)) return std::nullopt;
    std::vector<re2::StringPiece> groups(captures_.size() + 1);
    if (!expression_->Match(text, 0, text.size(), re2::RE2::ANCHOR_BOTH, groups.data(),
                            static_cast<int>(groups.size()))) {
        return std::nullopt;
    }
    NameFields name;
    for (std::size_t i = 0; i < captures_.size(); ++i) {
        const re2::StringPiece& group = groups[i + 1];
        if (group.data() == nullptr) continue;
        const std::string_view value_text(group.data(), group.size());
        if (captures_[i] == NameField::camera) {
            if (name.camera.empty()) name.camera = value_text;
            continue;
        }
        auto& value = name.values[static_cast<std::size_t>(captures_[i])];
        const std::int64_t more = value_of(captures_[i], value_text);
        if (!value) {
            value = more;
        } else if (*value != more && captures_[i] != NameField::number) {
            name.contradicts = true;
        }
    }
    return name;
}

}  // namespace vvr::video
