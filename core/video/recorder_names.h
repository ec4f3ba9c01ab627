#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/video/recorder_pattern.h"

// What the names of a recorder's files tell. Names are bytes that anybody may have written: they are matched, never
// followed.
namespace vvr::video {

/// The moment of a time in a name, in seconds since 1970 (UTC).
/// \param near a moment that can't be far off, for the hour that comes twice when summer time ends
std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near = {});

/// What a name tells.
struct RecorderName {
    std::string layout;                ///< whose name it is: that of a row, or "--names"; empty = nobody's
    std::string camera;                ///< empty = it tells none
    bool below = false;                ///< the camera is one of those in its folder, which is a part of its name
    std::optional<NamedTime> begin{};  ///< of the recording
    bool ambiguous = false;            ///< nobody can read its time for sure
};

/// What speaks against a time that a row reads.
enum class Ambiguity {
    none,
    day_or_month,   ///< which of two numbers is the month: only days after the 12th are told
    repeated_hour,  ///< 20/20-05 is 20:05 or 20:20:05
    always          ///< the name has a date that nobody can read for sure
};

/// What the camera of a row is.
enum class NamedCamera {
    whole,  ///< all there is to say, as the recorder knows all its cameras by name
    below,  ///< one of those whose files lie in the folder, by what is in front of the time
    folder  ///< the same, by a folder
};

/// A way to name files.
class NamingScheme {
  public:
    /// \param pattern for a path without its ending, or for as many of its last folders as the pattern has. Fields are
    ///        those of strftime (%Y %y %m %d %H %M %S, %s, %z; `%-m` is written without zeros), {camera}, {number} for
    ///        digits, `*` for any text, `?` for any character; %% is a percent sign
    /// \param utc whether times are in UTC
    /// \throws Error usage for an unknown field, or when no field tells the camera or the time
    NamingScheme(std::string_view name, std::string_view pattern, bool utc = false);

    /// Nothing when the name is none of this layout.
    std::optional<RecorderName> read(std::string_view path) const;

  private:
    friend class RecorderNames;
    NamingScheme(std::string_view name, RecorderPattern pattern, bool utc, Ambiguity doubt, NamedCamera camera);

    std::optional<RecorderName> read_stem(std::string_view stem) const;

    std::string name_;
    RecorderPattern pattern_;
    bool utc_;
    Ambiguity ambiguity_ = Ambiguity::none;
    NamedCamera camera_ = NamedCamera::whole;
};

/// The layouts of a user, then those of recorders that are known.
class RecorderNames {
  public:
    /// \param base folder that paths are below; with it, a path says the same wherever one stands
    /// \throws Error usage as NamingScheme does
    explicit RecorderNames(std::span<const std::string> patterns = {}, const std::filesystem::path& base = {});

    /// \param path as many of its last folders are looked at as a layout has; which layout comes first decides
    RecorderName read(std::string_view path) const;

    /// The camera of a file: as its name tells, else as `camera_of_folders` does; empty where there is none.
    /// \param skipped bytes at the front of `path` whose folders are no camera
    std::string camera_of(std::string_view path, std::size_t skipped = 0) const;

  private:
    std::string whole(std::string_view path) const;

    std::vector<NamingScheme> layouts_;
    std::string folder_;  ///< with a `/` at its end; empty = none
};

/// The names of the recorders whose layouts are known, for help texts.
std::vector<std::string> known_recorders();

}  // namespace vvr::video
