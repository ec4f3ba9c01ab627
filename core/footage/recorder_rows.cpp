#include "core/footage/recorder_rows.h"

#include "core/footage/name_expression.h"

namespace vvr::footage {

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
