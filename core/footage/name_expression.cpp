#include "core/footage/name_expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <re2/re2.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"

namespace vvr::footage {

namespace {

constexpr std::string_view month_names = "jan feb mar apr may jun jul aug sep oct nov dec";

struct WordRow {
    std::string_view name;
    std::string_view field;  ///< empty = text that is not read
    std::string_view expression;
};

constexpr std::array words{
    WordRow{"*", "", "[^/]*?"},
    WordRow{"?", "", "[^/]"},
    WordRow{"{camera}", "camera", "[^/]+?"},
    WordRow{"{number}", "", "[0-9]{1,18}"},
    WordRow{"%Y", "Y", "19[7-9][0-9]|2[01][0-9][0-9]"},
    WordRow{"%y", "y", "[0-9][0-9]"},
    WordRow{"%m", "m", "0[1-9]|1[0-2]"},
    WordRow{"%-m", "m", "0[1-9]|1[0-2]|[1-9]"},
    WordRow{"%b", "b", "(?i:jan|feb|mar|apr|may|jun|jul|aug|sep|oct|nov|dec)"},
    WordRow{"%d", "d", "0[1-9]|[12][0-9]|3[01]"},
    WordRow{"%-d", "d", "0[1-9]|[12][0-9]|3[01]|[1-9]"},
    WordRow{"%H", "H", "[01][0-9]|2[0-3]"},
    WordRow{"%-H", "H", "[01][0-9]|2[0-3]|[0-9]"},
    WordRow{"%I", "I", "0[1-9]|1[0-2]"},
    WordRow{"%-I", "I", "0[1-9]|1[0-2]|[1-9]"},
    WordRow{"%p", "p", noon_expression},
    WordRow{"%M", "M", "[0-5][0-9]"},
    WordRow{"%S", "S", "[0-5][0-9]|60"},
    WordRow{"%s", "s", "[0-9]{9,11}"},
    WordRow{"%z", "z", zone_expression},
};

constexpr std::size_t longest_pattern = 255;
constexpr std::size_t longest_path = 4096;

[[noreturn]] void refuse_pattern(std::string_view pattern, std::string_view why) {
    throw Error(ErrorCode::name_pattern_invalid,
                fmt::format("'{}' is not a pattern of file names: {}; an example is Frigate's "
                            "'%Y-%m-%d/%H/{{camera}}/%M.%S'",
                            pattern, why),
                {"names"});
}

re2::RE2::Options name_options() {
    re2::RE2::Options options(re2::RE2::Latin1);  // a name is bytes, of any value
    options.set_log_errors(false);
    options.set_dot_nl(true);
    return options;
}

std::int64_t number_in(std::string_view digits) {
    std::int64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// Parses "Z", "UTC", "GMT+1", "+01:00", "+01_00" or "-0330" as an offset from UTC in seconds.
std::int64_t zone_in(std::string_view text) {
    const std::size_t sign = text.find_first_of("+-");
    if (sign == std::string_view::npos) return 0;
    const bool west = text[sign] == '-';
    text.remove_prefix(sign + 1);
    const std::size_t hours = std::min<std::size_t>(std::min(text.find(':'), text.size()), 2);
    std::int64_t ahead = number_in(text.substr(0, hours)) * 3600;
    if (text.size() > 2) ahead += number_in(text.substr(text.size() - 2)) * 60;
    return west ? -ahead : ahead;
}

/// The hour of the day; none if the name has none.
std::optional<std::int64_t> hour_of(const NameFields& fields) {
    const auto noon = fields.find("p");
    const std::optional<std::int64_t> hour = number_of(fields, "I");
    if (!hour || noon == fields.end()) return hour ? hour : number_of(fields, "H");
    return *hour % 12 + (noon->second.front() == 'p' || noon->second.front() == 'P' ? 12 : 0);
}

/// Whether the text after a time says more of it: AM, PM or a zone, of which most abbreviations mean several offsets.
bool goes_on(std::string_view rest) {
    static const re2::RE2 more(
        fmt::format(
            "[-_. ]?(?:{}|{}|"
            "A[CEKW]?[DS]T|ART|BRT|[BGIJKM]ST|CES?T|CAT|CLT|COT|[CEHMP][DS]T|EAT|EES?T|HKT|ICT|IDT|MESZ|MEZ|MSK|"
            "NZ[DS]T|PHT|PKT|SAST|SGT|WAT|WET|WIB)(?:[^0-9A-Za-z].*)?",
            noon_expression, "Z|(?:UTC|GMT)(?:[-+][0-9:]*)?"),
        name_options());
    return re2::RE2::FullMatch(re2::StringPiece(rest.data(), rest.size()), more);
}

}  // namespace

std::optional<std::int64_t> number_of(const NameFields& fields, std::string_view field) {
    const auto found = fields.find(field);
    return found == fields.end() ? std::nullopt : std::optional(number_in(found->second));
}

std::optional<NamedTime> time_of(const NameFields& fields, bool utc) {
    if (const auto epoch = number_of(fields, "s")) return NamedTime{*epoch, 0};
    if (const auto epoch = number_of(fields, "ms")) return NamedTime{*epoch / 1000, 0};
    const std::optional<std::int64_t> hour = hour_of(fields);
    if (!hour) return std::nullopt;
    const std::optional<std::int64_t> of_century = number_of(fields, "y");
    const std::int64_t year = of_century ? 2000 + *of_century : number_of(fields, "Y").value_or(0);
    std::int64_t month = number_of(fields, "m").value_or(0);
    if (const auto name = fields.find("b"); name != fields.end()) {
        month = static_cast<std::int64_t>(month_names.find(lower_case(name->second)) / 4) + 1;
    }
    const auto midnight = seconds_of_date(year, month, number_of(fields, "d").value_or(0));
    if (!midnight) return std::nullopt;
    const std::int64_t clock =
        *hour * 3600 + number_of(fields, "M").value_or(0) * 60 + number_of(fields, "S").value_or(0);
    NamedTime time{*midnight + clock, {}};
    if (const auto zone = fields.find("z"); zone != fields.end()) time.ahead = zone_in(zone->second);
    if (!time.ahead && utc) time.ahead = 0;
    return time;
}

NameExpression::NameExpression(const std::string& expression)
    : expression_(std::make_shared<re2::RE2>("(?:.*/)?(?:" + expression + ")", name_options())) {
    if (!expression_->ok()) refuse_pattern(expression, fmt::format("it is too long ({})", expression_->error()));
}

std::optional<NameFields> NameExpression::read(std::string_view path) const {
    if (path.size() > longest_path) return std::nullopt;
    const re2::StringPiece text(path.data(), path.size());
    // Most names don't match. Matching without groups is much faster, so it comes first.
    if (!expression_->Match(text, 0, text.size(), re2::RE2::ANCHOR_BOTH, nullptr, 0)) return std::nullopt;
    const std::map<int, std::string>& group_names = expression_->CapturingGroupNames();
    std::vector<re2::StringPiece> groups(group_names.size() + 1);
    if (!expression_->Match(text, 0, text.size(), re2::RE2::ANCHOR_BOTH, groups.data(),
                            static_cast<int>(groups.size()))) {
        return std::nullopt;
    }
    NameFields fields;
    std::size_t end = 0;  // of the time
    for (const auto& [index, name] : group_names) {
        const re2::StringPiece& group = groups[static_cast<std::size_t>(index)];
        if (group.data() == nullptr) continue;
        std::string field = name.substr(0, name.find_last_not_of("0123456789") + 1);
        if (field.size() == 1) end = std::max(end, static_cast<std::size_t>(group.data() + group.size() - text.data()));
        const auto [known, is_new] = fields.try_emplace(field, group);
        if (!is_new && field != "camera" && known->second != group) return std::nullopt;
    }
    const bool timed = end > 0 && !fields.contains("z");
    if (timed && goes_on(path.substr(end))) fields["unread"];
    return fields;
}

std::string expression_of(std::string_view pattern) {
    if (pattern.empty() || pattern.size() > longest_pattern)
        refuse_pattern(pattern, fmt::format("it has {} bytes, not 1 to {}", pattern.size(), longest_pattern));
    std::string expression;
    std::map<std::string_view, int, std::less<>> count;
    for (std::string_view rest = pattern; !rest.empty();) {
        const auto row = std::ranges::find_if(words, [&](const WordRow& word) { return rest.starts_with(word.name); });
        if (row != words.end()) {
            rest.remove_prefix(row->name.size());
            const std::string group =
                row->field.empty() ? ":" : fmt::format("P<{}{}>", row->field, ++count[row->field]);
            expression += fmt::format("(?{}{})", group, row->expression);
            continue;
        }
        const bool percent = rest.starts_with("%%");
        if (!percent && (rest.front() == '%' || rest.front() == '{')) {
            const std::size_t end = rest.front() == '%' ? 2 : std::min(rest.find('}'), rest.size() - 1) + 1;
            refuse_pattern(pattern, fmt::format("unknown field '{}' (known: {})", rest.substr(0, end),
                                                fmt::join(names_of(words), " ")));
        }
        expression += re2::RE2::QuoteMeta(re2::StringPiece(rest.data(), 1));
        rest.remove_prefix(percent ? 2 : 1);
    }
    const auto has = [&](std::string_view field) { return count.contains(field); };
    const bool hour = has("H") || (has("I") && has("p"));
    const bool day = (has("Y") || has("y")) && (has("m") || has("b")) && has("d");
    const bool partly = day || hour || has("I") || has("m") || has("b") || has("d");
    const bool whole = has("s") || (day && hour);
    if (partly && !whole) refuse_pattern(pattern, "a time needs %Y, %m (or %b), %d and %H (or %I with %p), or %s");
    if (!whole && !has("camera")) refuse_pattern(pattern, "it has neither {camera} nor a time");
    return expression;
}

namespace {

constexpr std::string_view by_name = "a date and a time";
constexpr std::string_view by_folder = "a folder of a date";
constexpr std::string_view by_epoch = "seconds since 1970";

}  // namespace

std::vector<RecorderRow> recorder_rows() {
    using std::string;
    // Groups are strftime's letters. Those of the same name, without digits, must agree: dash1 and dash2, H and H2.
    const string Y = R"((?P<Y>19[7-9]\d|2[01]\d\d))", m = "(?P<m>0[1-9]|1[0-2])", d = R"((?P<d>0[1-9]|[12]\d|3[01]))";
    const string H = R"((?P<H>[01]\d|2[0-3]))", M = R"((?P<M>[0-5]\d))", S = R"((?P<S>[0-5]\d|60))";
    const string z = "(?P<z>" + string(zone_expression) + ")", p = "[-_. ]?(?P<p>" + string(noon_expression) + ")";
    const string camera = "(?P<camera>[^/]+?)", named = R"((?P<camera1>[^/]*[^\d/][^/]*))";
    const string also_named = R"((?P<camera2>[^/]*[^\d/][^/]*))";
    const string ymd = Y + m + d, hms = H + M + S, stamp = ymd + hms;

    const string date = Y + "(?P<dash1>[-_.]?)" + m + "(?P<dash2>[-_.]?)" + d;
    const string dated = Y + "[-_./]?" + m + "[-_./]?" + d;
    // A clock with or without separators; of 24 hours, or of 12 with AM or PM.
    const auto clock24 = [&](const string& separator) {
        return H + "(?:h|(?P<colon1>" + separator + "))" + M + "(?:m|(?P<colon2>" + separator + "))" + S;
    };
    const auto clock12 = [&](const string& separator) {
        return R"((?P<I>0?[1-9]|1[0-2])(?P<colon3>)" + separator + R"()(?P<M2>[0-5]\d)(?P<colon4>)" + separator +
               R"()(?P<S2>[0-5]\d))" + p;
    };
    // What may follow: nothing, or text that doesn't continue the number, or the word.
    const string more = R"((?:[^\d/][^/]*)?)", apart = R"((?:[^\dA-Za-z/][^/]*)?)";
    // A zone behind a clock. With a minus, it could be the next number: it needs minutes.
    const auto in_zone = [&](const string& number) {
        return "(?:[-_. ]?(?P<z" + number + R"(>Z|(?:UTC|GMT)(?:[-+](?:0\d|1[0-4]|\d)(?::?[0-5]\d)?)?|)" +
               R"([+](?:0\d|1[0-4])(?:[:_]?[0-5]\d)?|-(?:0\d|1[0-4]):[0-5]\d))" + apart + "|(?P<z1" + number +
               R"(>-(?:0\d|1[0-4])_[0-5]\d)(?:[^\dA-Za-z/][^\d/][^/]*)?))";
    };
    const auto time = [&](const string& separator, const string& rest) {
        return "(?:" + clock12(separator) + "(?:" + in_zone("2") + "|" + apart + ")|" + clock24(separator) +
               R"((?:s|\d{3})?(?:(?:[.,]\d{1,9})?)" + in_zone("3") + "|" + rest + "))";
    };
    const string any = "[-_.:]?", some = "[-_.:]";
    const string minute = H + "[-._:h]?" + M + "m?";
    const string join = "(?:[-_. T@]|_-_| - | at |, |--|__)", gap = R"((?:[-_. (\[@]{1,3}| at ))";
    const string until = R"((?:[-_ ]{1,3}(?:to[-_ ])?(?:\d{4}[-_.]?\d\d[-_.]?\d\d[-_ T])?\d\d[-._:h]?\d\d)?)";
    const string after_camera = "(?:" + camera + gap + ")??";
    const string side =
        "(?P<camera>(?i:(?:cam|camera|ch|channel)[-_ ]?[0-9]{1,3}|front|back|rear|left|right|"
        "left_repeater|right_repeater|left_pillar|right_pillar))";
    const string hour_of_folder = dated + "(?:/(?:" + named + "/)?|" + join + ")" + H + "h?/(?:" + also_named + "/)?";
    const string us_date = R"((?P<m>0?[1-9]|1[0-2])-(?P<d>0?[1-9]|[12]\d|3[01])-)" + Y;
    const string us_clock = "(?:" + clock12("[.]") + R"(|(?P<H>[01]\d|2[0-3]|\d)\.)" + M + "[.]" + S + ")";
    const string unsure = R"((?:[^/]*[^-_. \d/][-_. ]{0,3})?\d{1,2}[-._ ]\d{1,2}[-._ ](?:19|20)\d\d[^\d][^/]*)";

    using enum NamedCamera;
    return {
        {"Frigate", Y + "-" + m + "-" + d + "/" + H + "/" + camera + "/" + M + "[.]" + S, whole, {}, NamedZone::utc},
        {"Frigate", Y + "-" + m + "/" + d + "/" + H + "/" + camera + "/" + M + "[.]" + S},  // before version 0.12
        {"Frigate", camera + R"(-(?P<s>1\d{9}|2[01]\d{8})\.\d{1,18}-[^/]*)"},
        {"Frigate", "in_progress[.]" + camera + "@" + date + "_" + H + "_" + M + "__[^/]*"},
        {"Dahua", dated + "/001/dav/" + R"((?P<H2>\d\d)/)" + H + "[.]" + M + "[.]" + S + "-[^/]*"},
        {"Dahua", dated + "/" + camera + R"(/dav/(?P<H2>\d\d)/)" + H + "[.]" + M + "[.]" + S + "-[^/]*", folder},
        {"Dahua", dated + "/" + H + "[.]" + M + "[.]" + S + R"(-\d{1,18}\.\d{1,18}\.\d{1,18}\[[^/]*)"},
        {"Dahua", camera + "_(?:main|(?P<sub>sub))_" + stamp + "_[^/]*"},
        {"Hikvision", camera + "_hiknvr_" + stamp + "_[^/]*"},
        {"Reolink", camera + "_00_" + stamp},
        {"Reolink", "Rec(?:M|(?P<sub>S)|[^/])[^/]*?" + ymd + "_" + hms + "_[^/]*"},  // on the camera's SD card
        {"Hikvision", camera + "_" + stamp + R"(\d{1,18})"},
        {"Synology", camera + "-" + ymd + "-" + hms + R"(-\d{1,18}[^/]*)"},
        {"BlackVue", ymd + "_" + hms + "_[A-Z](?P<camera>[FRIO])", below},
        {"Blue Iris", camera + "[.]" + ymd + "_" + time("", "[^/]*")},
        {"UniFi", camera + "(?: -)? " + us_date + ", " + us_clock + " GMT" + z + "[^/]*"},
        {"UniFi", camera + "(?: -)? " + us_date + ", " + us_clock + "[^/]*", whole, Ambiguity::day_or_month},
        {"ZoneMinder", camera + R"(/(?P<y>\d\d)/)" + m + "/" + d + "/" + H + "/" + M + "/" + S + R"(/\d{1,18}-video)"},
        {"ZoneMinder", camera + "/" + Y + "-" + m + "-" + d + R"(/\d{1,18}/\d{1,18}-video)"},
        {"Xiaomi", ymd + H + "/" + M + "M" + S + R"(S_(?P<s>\d{9,11}))"},
        {"Xiaomi", Y + "Y" + m + "M" + d + "D" + H + "H/" + M + "M" + S + "S[^/]*"},
        {"motion", R"(\d{1,18}-)" + stamp},
        {"motion", Y + "-" + m + "-" + d + "/" + H + "-" + M + "-" + S},  // motionEye
        // The time is that of sending, and day and month may be swapped.
        {"", "WhatsApp [^/]*", whole, Ambiguity::always},
        {"", unsure, whole, Ambiguity::always},
        // Date and time in the name, with the camera before them, after them, or without it.
        {by_name, after_camera + date + "T" + clock24(any) + R"((?P<z>[-+]\d{4}))", below},
        {by_name, date + join + "?" + clock24(any) + R"((?:(?:s|\d{3})?)" + gap + side + "|(?P<camera1>[FR]))", below},
        {by_name, after_camera + date + join + "?" + time(any, more), below},
        {by_name, after_camera + date + join + "?" + minute + until, below},
        {by_name, R"([^/]*?[^\d/])" + date + join + "?" + time(any, more)},
        // The date in folders, the time in the name.
        {by_folder, dated + "/(?:" + named + R"(/)?(?P<H2>\d\d)/(?:)" + camera + "/)?" + time(any, apart), folder},
        {by_folder, hour_of_folder + M + "(?:m(?:" + S + "s)?)?", folder},
        {by_folder, hour_of_folder + M + R"([^\d/])" + S, folder, Ambiguity::repeated_hour},
        {by_folder, dated + R"(/(?P<H2>\d\d)/)" + minute + until},
        {by_folder, dated + "/" + clock24(any) + R"((?:s|\d{3})?)" + gap + side, below},
        {by_folder, dated + "/(?:" + camera + "/)?" + time(any, apart), folder},
        {by_folder, dated + "/(?:" + named + "/)?" + minute + until, folder},
        {by_folder, dated + "/" + camera + gap + time(some, apart), below},
        {by_epoch,
         after_camera + R"((?:(?P<s>1\d{9}|2[01]\d{8})|(?P<ms>1\d{12}|2[01]\d{11})))"
                        R"((?:[-_ ][12]\d{9}|[-_ ][12]\d{12})?)",
         below},
    };
}

}  // namespace vvr::footage
