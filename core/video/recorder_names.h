#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace re2 {
class RE2;
}

// Reads camera and time from the names of a recorder's files. Names are untrusted: they are only matched, and never
// used to open files.
namespace vvr::video {

/// A time as written in a file name.
struct NamedTime {
    std::int64_t clock = 0;             ///< seconds since 1970-01-01 00:00 on the recorder's clock
    std::optional<std::int64_t> ahead;  ///< offset from UTC, seconds; none = local time

    friend bool operator==(const NamedTime&, const NamedTime&) = default;
};

/// The meaning of a field in a pattern.
enum class NameField {
    text,
    camera,
    number,
    year,
    year_of_century,
    month,
    day,
    hour,
    minute,
    second,
    epoch,
    epoch_ms,
    zone,
    count
};

/// The values of a pattern's fields in a file name.
struct NameFields {
    std::string camera{};
    std::array<std::optional<std::int64_t>, static_cast<std::size_t>(NameField::count)> values{};
    bool contradicts = false;  ///< the name has two values of one field

    const std::optional<std::int64_t>& operator[](NameField field) const {
        return values[static_cast<std::size_t>(field)];
    }

    /// The time in the name. Empty if there is none or it doesn't exist, such as February 30.
    /// \param utc whether a time without a time zone is in UTC
    std::optional<NamedTime> time(bool utc) const;
};

/// A pattern of file names, text with fields, compiled to a regular expression. Matching takes time linear in the
/// name's length, so untrusted names are safe.
class RecorderPattern {
  public:
    enum class Words {
        fields,         ///< the fields in docs/archive.md
        fields_and_own  ///< also the fields of known recorders' patterns
    };

    /// \throws Error usage for an unknown field, or if no field is the camera or a time
    explicit RecorderPattern(std::string_view pattern, Words words = Words::fields);

    /// Empty if the path doesn't match.
    /// \param path matched by its last folders, as many as the pattern has
    std::optional<NameFields> read(std::string_view path) const;

    /// A regular expression, in the syntax of RE2, that matches at least the paths that a pattern of
    /// Words::fields_and_own matches. It is smaller than the pattern's own one, so it is compiled in less time.
    static std::string loose_expression(std::string_view pattern);

  private:
    std::shared_ptr<const re2::RE2> expression_;
    std::vector<NameField> captures_;
};

/// Converts a time in a name to seconds since 1970 (UTC).
/// \param near approximately the same time, not the end of the recording, to resolve the hour that repeats at the end
/// of daylight saving time
std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near = {});

/// What a file name states.
struct RecorderName {
    std::string layout;                ///< the recorder's name, or "--names"; empty = unknown
    std::string camera;                ///< empty = unknown
    bool below = false;                ///< the camera's folder is a part of its name
    std::string numbered{};            ///< "video1" before the time: the name of a camera, or a count of its files
    std::optional<NamedTime> begin{};  ///< start of the recording
    bool ambiguous = false;            ///< its time can be read in several ways
};

/// Why the time that a naming scheme reads may be ambiguous.
enum class Ambiguity {
    none,
    day_or_month,   ///< day and month may be swapped, except for days after the 12th
    repeated_hour,  ///< 20/20-05 is 20:05 or 20:20:05
    always          ///< the name has a date that is always ambiguous
};

/// How a naming scheme names cameras.
enum class NamedCamera {
    whole,  ///< by a name that is unique for the recorder
    below,  ///< by the text before the time; unique only within the folder
    folder  ///< by a folder; unique only within the parent folder
};

/// A naming scheme for files.
class NamingScheme {
  public:
    /// \param pattern matches a path without its extension, or its last folders, as many as the pattern has. Fields:
    ///        strftime's %Y %y %m %d %H %M %S %s %z (`%-m` has no leading zeros), {camera}, {number} for digits, `*`
    ///        for any text, `?` for any character, %% for a percent sign
    /// \param utc whether times are in UTC
    /// \throws Error usage for an unknown field, or if no field is the camera or a time
    NamingScheme(std::string_view name, std::string_view pattern, bool utc = false);

    /// Empty if the name doesn't match.
    std::optional<RecorderName> read(std::string_view path) const;

  private:
    friend class KnownSchemes;
    NamingScheme(std::string_view name, RecorderPattern pattern, bool utc, Ambiguity doubt, NamedCamera camera);

    std::optional<RecorderName> read_stem(std::string_view stem) const;

    std::string name_;
    RecorderPattern pattern_;
    bool utc_;
    Ambiguity ambiguity_ = Ambiguity::none;
    NamedCamera camera_ = NamedCamera::whole;
};

/// The user's naming schemes, followed by those of known recorders.
class RecorderNames {
  public:
    /// \param base folder of relative paths, so that results don't depend on the working folder
    /// \throws Error usage as NamingScheme
    explicit RecorderNames(std::span<const std::string> patterns = {}, const std::filesystem::path& base = {});

    /// The result of the first scheme that matches.
    /// \param path matched by its last folders, as many as a scheme has
    RecorderName read(std::string_view path) const;

    /// The camera of a file, from its name, or else from its folders. Empty if unknown.
    /// \param skipped leading bytes of `path` whose folders are not a camera
    std::string camera_of(std::string_view path, std::size_t skipped = 0) const;

    /// Decides for names such as "video1_2026-11-21_20-00-00" whether the number is a camera's or counts files. It is a
    /// camera's if most files have a number that others have too, or begin with a file of another number, and if
    /// `describe_camera` names it. Else these cameras are unknown.
    /// \param paths all files that belong together, such as those of an archive
    void find_numbered_cameras(std::span<const std::string> paths);

    /// Describes the names of one camera's files; these patterns are tried first there. They give times. Which camera
    /// a file is of depends on the other schemes only.
    /// \param camera as in `name_of_camera`
    void describe_camera(const std::string& camera, std::span<const std::string> patterns);

  private:
    std::string camera_of(const RecorderName& name, std::string_view whole_path, std::size_t skipped) const;
    RecorderName read_whole(std::string_view whole_path) const;
    RecorderName read_with(std::string_view whole_path, std::span<const NamingScheme* const> schemes) const;
    std::string whole(std::string_view path) const;

    std::vector<NamingScheme> own_;  ///< the user's
    std::map<std::string, std::vector<NamingScheme>> of_cameras_;
    std::set<std::string> numbered_;  ///< keys of names whose number is a camera's
    std::string folder_;              ///< ends with `/`; empty = none
};

/// The one of some names that means a camera: its whole name, or the end of it from a folder on ("gate" means
/// "house/gate"). The longest one; empty if there is none.
std::string name_of_camera(std::string_view camera, std::span<const std::string> names);

/// The names of the known recorders, for help texts.
std::vector<std::string> known_recorders();

}  // namespace vvr::video
