#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/archive/clips.h"
#include "core/archive/sidecar.h"
#include "core/base/lock_file.h"
#include "core/footage/recorder_names.h"

namespace vvr::archive {

/// The files in an archive's folder of pictures that belong to the archive.
struct Outputs {
    std::vector<Sidecar> sidecars;      ///< by path
    std::vector<ScanProblem> problems;  ///< unreadable folders, and files with a sidecar's name; paths below `out`
    std::vector<std::filesystem::path> locks;  ///< lock files of running or killed programs
};

/// Lists the files of an archive. A folder that does not exist has none.
/// \param in the folder of clips; skipped if it is inside `out`
/// \throws Error io
Outputs list_outputs(const std::filesystem::path& out, const std::filesystem::path& in);

/// Removes files and locks of killed programs that no later run would finish. Neither the index nor files of other
/// clips are removed.
void tidy(const std::filesystem::path& out, const Outputs& outputs);

/// Removes a clip's files and its sidecar, and what a killed program left of it.
/// \param in the folder of clips, as in `list_outputs`
/// \returns what the sidecar named and was removed, below `out`; nothing if another program is drawing the clip, or has
///          written its sidecar since
/// \throws Error io
std::optional<std::vector<std::string>> remove_clip(const std::filesystem::path& out, const std::filesystem::path& in,
                                                    const Sidecar& sidecar);

/// Removes what a killed program left of a clip: temporary files, and files that no sidecar names. Those from before
/// its lock stay: a complete run made them, and they may be all that is left of the clip. Neither the index nor files
/// of other clips are removed. \param in the folder of clips, as in `list_outputs` \param claim the clip's lock
void remove_unfinished(const std::filesystem::path& out, const std::filesystem::path& in, const std::string& clip,
                       const LockFile& claim);

/// The staging folder of a clip's files, next to their final place. It is hidden, and exists only while a program makes
/// them.
std::filesystem::path staging_of(const std::filesystem::path& out, const std::string& clip);

/// Removes a staging folder with its content. Of a link in its place, only the link is removed.
void remove_staging(const std::filesystem::path& staging);

/// The names of all files written for a clip, or for the index under its own name.
std::vector<std::string> written_names(const std::string& file_name);

/// Whether a file certainly doesn't exist. Without permission to look, that isn't certain.
bool is_gone(const std::filesystem::path& path);

/// Which clips of an archive exist, including those that a run leaves out.
struct Present {
    Scan scan;
    std::set<std::string> days;     ///< paths of the camera days with an existing clip, for each rule of a sidecar
    std::set<std::string> cameras;  ///< cameras with an existing clip
};

/// Looks at all clips. One that is still being written, is excluded or has an impossible time exists too.
/// \throws Error io if the folder can't be read
Present find_present(const std::filesystem::path& in, const std::filesystem::path& out, const ClipNames& names,
                     const footage::RecorderNames& recorders, const std::vector<Sidecar>& sidecars = {});

/// Whether a clip, or all clips of a day, are certainly gone.
enum class SourceState {
    there,    ///< one exists, or may exist
    gone,     ///< all are gone, but their folders exist
    away,     ///< the folder of one is empty, a broken link or missing: perhaps an unmounted disk
    moved,    ///< all are there, and belong to other days now
    unknown,  ///< the day's sidecar doesn't list its clips
};

struct SourceStatus {
    SourceState fate = SourceState::there;
    std::string folder;  ///< the missing folder, below `in`
};

SourceStatus source_state_of(const std::filesystem::path& in, const Sidecar& sidecar, const Present& present,
                             const footage::RecorderNames& recorders);

/// Refuses to prune where it is uncertain which clips are gone.
/// \throws Error io if there is no clip at all, or if a part of the folder can't be read
void check_can_prune(const std::filesystem::path& in, const Present& present);

}  // namespace vvr::archive
