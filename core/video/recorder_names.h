#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// What the names of a recorder's files tell. Names are bytes that anybody may have written: they are matched, never
// followed.
namespace vvr {

/// A time as a name has it.
struct NamedTime {
    std::int64_t clock = 0;             ///< seconds since 1970-01-01 00:00 on the recorder's clock
    std::optional<std::int64_t> ahead;  ///< seconds that this clock is ahead of UTC; none = it is on the local wall

    friend bool operator==(const NamedTime&, const NamedTime&) = default;
};

/// The moment of a time in a name, in seconds since 1970 (UTC).
/// \param near a moment that can't be far off, for the hour that comes twice when summer time ends
std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near = {});

/// What a name tells.
struct RecorderName {
    std::string layout;              ///< whose name it is: that of a row, or "--names"; empty = nobody's
    std::string camera;              ///< empty = it tells none
    std::optional<NamedTime> begin;  ///< of the recording
};

/// A way to name files: text with fields.
class RecorderLayout {
  public:
    /// \param pattern for a path without its ending, or for as many of its last folders as the pattern has. Fields are
    ///        those of strftime (%Y %y %m %d %H %M %S, %s, %z; `%-m` is written without zeros), {camera}, {number} for
    ///        digits, `*` for any text, `?` for any character; %% is a percent sign
    /// \param utc whether times are in UTC
    /// \throws Error usage for an unknown field, or when no field tells the camera or the time
    RecorderLayout(std::string_view name, std::string_view pattern, bool utc = false);

    /// Nothing when the name is none of this layout.
    std::optional<RecorderName> read(std::string_view path) const;

  private:
    class Match;
    struct Part {
        std::string_view field;  ///< as in the table of fields; empty = text
        std::string text{};
    };

    std::string name_;
    std::vector<Part> parts_;
    std::size_t folders_ = 0;
    bool utc_;
};

/// The layouts of a user, then those of recorders that are known.
class RecorderNames {
  public:
    /// \throws Error usage as RecorderLayout does
    explicit RecorderNames(std::span<const std::string> patterns = {});

    /// \param path below the folder of all recordings; which layout comes first decides
    RecorderName read(std::string_view path) const;

    /// The camera of a file: as its name tells, else the folders before the first that is a date, else the first folder
    /// after the date that is neither date nor hour; empty where there is none.
    std::string camera_of(std::string_view path) const;

  private:
    std::vector<RecorderLayout> layouts_;
};

/// The names of the recorders whose layouts are known, for help texts.
std::vector<std::string> known_recorders();

}  // namespace vvr
