#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace re2 {
class RE2;
}

// Reads fields of file names with regular expressions. Names are untrusted: they are only matched, and never used to
// open files.
namespace vvr::footage {

/// A time as written in a file name.
struct NamedTime {
    std::int64_t clock = 0;             ///< seconds since 1970-01-01 00:00 on the recorder's clock
    std::optional<std::int64_t> ahead;  ///< offset from UTC, seconds; none = local time

    friend bool operator==(const NamedTime&, const NamedTime&) = default;
};

/// The texts of the named groups. `camera`, and strftime's letters: Y y m d b H I p M S s z; `ms` for milliseconds
/// since 1970. Other groups must only agree.
using NameFields = std::map<std::string, std::string, std::less<>>;

/// The number of a field; none if the name doesn't have it.
std::optional<std::int64_t> number_of(const NameFields& fields, std::string_view field);

/// The time in a name. Empty if there is none or it doesn't exist, such as February 30.
/// \param utc whether a time without a time zone is in UTC
std::optional<NamedTime> time_of(const NameFields& fields, bool utc);

/// A regular expression in the syntax of RE2, for a path or its last folders. Matching takes time linear in the name's
/// length, so untrusted names are safe. A group's name may end with digits: "H" and "H2" are the same field, and if
/// both match, they must have the same text; of two cameras the first counts.
class NameExpression {
  public:
    /// \throws Error usage if the expression is too long
    explicit NameExpression(const std::string& expression);

    /// Empty if the path doesn't match. If AM, PM or a time zone follows the time that no group has, there is a field
    /// `unread`: the time is not known.
    std::optional<NameFields> read(std::string_view path) const;

  private:
    std::shared_ptr<const re2::RE2> expression_;
};

/// The expression of a pattern of `--names`: text with the fields in docs/archive.md.
/// \throws Error usage for an unknown field, or if no field is the camera or a time
std::string expression_of(std::string_view pattern);

/// What follows a time: AM or PM, and a time zone. Group names are left to who uses them.
inline constexpr std::string_view noon_expression = R"([AaPp]\.?[Mm]\.?)";
inline constexpr std::string_view zone_expression = R"(Z|(?:UTC|GMT)(?:[-+](?:0\d|1[0-4]|\d)(?::?[0-5]\d)?)?|)"
                                                    R"([-+](?:0\d|1[0-4])(?:[:_]?[0-5]\d)?|[-+]\d(?::[0-5]\d)?)";

// The naming schemes of known recorders.

/// Why the time that a naming scheme reads may be ambiguous.
enum class Ambiguity {
    none,
    day_or_month,   ///< day and month may be swapped, unless the day is after the 12th or other names tell
    repeated_hour,  ///< 20/20-05 is 20:05 or 20:20:05
    always          ///< the name has a date that is always ambiguous
};

/// How a naming scheme names cameras.
enum class NamedCamera {
    whole,  ///< by a name that is unique for the recorder
    below,  ///< by the text before the time; unique only within the folder
    folder  ///< by a folder; unique only within the parent folder
};

enum class NamedZone { local, utc };

struct RecorderRow {
    std::string_view recorder;
    std::string expression;  ///< for `NameExpression`; without the file extension
    NamedCamera camera = NamedCamera::whole;
    Ambiguity doubt = Ambiguity::none;
    NamedZone zone = NamedZone::local;
};

/// In the order in which they are tried: specific rows come first, because the last ones match many names.
std::vector<RecorderRow> recorder_rows();

}  // namespace vvr::footage
