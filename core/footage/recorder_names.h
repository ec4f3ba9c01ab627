#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/footage/name_expression.h"

// Reads camera and time from the names of a recorder's files.
namespace vvr::footage {

/// Converts a time in a name to seconds since 1970 (UTC).
/// \param near approximately the same time, not the end of the recording, to resolve the hour that repeats at the end
/// of daylight saving time
std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near = {});

/// What a file name states.
struct RecorderName {
    std::string scheme;                ///< the recorder's name, or "--names"; empty = unknown
    std::string camera;                ///< empty = unknown
    bool below = false;                ///< the camera's folder is a part of its name
    std::string numbered{};            ///< "video1" before the time: the name of a camera, or a count of its files
    std::optional<NamedTime> begin{};  ///< start of the recording
    bool ambiguous = false;            ///< its time can be read in several ways
    bool shows_month = false;          ///< its day can't be a month
    bool no_clock = false;             ///< its date is that of a camera without the time: 1970, 2000-01-01
    bool sub = false;                  ///< the small one of a camera's two streams
};

/// A naming scheme for files.
struct NamingScheme {
    RecorderRow row;
    NameExpression expression;
};

/// The user's naming schemes, followed by those of known recorders.
class RecorderNames {
  public:
    /// \param base folder of relative paths, so that results don't depend on the working folder
    /// \throws Error usage as expression_of
    explicit RecorderNames(std::span<const std::string> patterns = {}, const std::filesystem::path& base = {});

    bool has_patterns() const { return !own_.empty(); }

    /// The result of the first scheme that matches.
    /// \param path matched by its last folders, as many as a scheme has
    RecorderName read(std::string_view path) const;

    /// The camera of a file, from its name, or else from its folders. Empty if unknown.
    /// \param skipped leading bytes of `path` whose folders are not a camera
    std::string camera_of(std::string_view path, std::size_t skipped = 0) const;

    /// Compares names with each other.
    ///
    /// In "video1_2026-11-21_20-00-00" the number is a camera's or counts files. It is a camera's if most files have a
    /// number that others have too, or begin with a file of another number, and if `describe_camera` names it. Else
    /// these cameras are unknown. In "2-9-2020", the month comes first if another name of the folder shows it:
    /// "2-19-2020".
    /// \param paths all files that belong together, such as those of an archive
    void compare(std::span<const std::string> paths);

    /// Describes the names of one camera's files; these patterns are tried first there. They give times. Which camera
    /// a file is of depends on the other schemes only.
    /// \param camera as in `name_of_camera`
    void describe_camera(const std::string& camera, std::span<const std::string> patterns);

  private:
    std::string camera_of(const RecorderName& name, std::string_view whole_path, std::size_t skipped) const;
    RecorderName read_whole(std::string_view whole_path) const;
    RecorderName read_with(std::string_view whole_path, std::span<const NamingScheme> first,
                           std::span<const NamingScheme> second) const;
    std::optional<RecorderName> read_as(const NamingScheme& scheme, std::string_view path) const;
    std::string whole(std::string_view path) const;

    std::vector<NamingScheme> own_;  ///< the user's
    std::map<std::string, std::vector<NamingScheme>> of_cameras_;
    std::set<std::string> numbered_;                  ///< keys of names whose number is a camera's
    std::set<std::string, std::less<>> month_first_;  ///< folders whose names show it, with '/'
    std::string folder_;                              ///< ends with `/`; empty = none
};

/// The one of some names that means a camera: its whole name, or the end of it from a folder on ("gate" means
/// "house/gate"). The longest one; empty if there is none.
std::string name_of_camera(std::string_view camera, std::span<const std::string> names);

/// "2 files are dated 1970, ..."
std::string text_of_unset_clocks(std::int64_t files);

/// The names of the known recorders, for help texts.
std::vector<std::string> known_recorders();

}  // namespace vvr::footage
