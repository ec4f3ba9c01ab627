#pragma once

#include <string>
#include <string_view>
#include <vector>

// The naming schemes of known recorders.
namespace vvr::footage {

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
