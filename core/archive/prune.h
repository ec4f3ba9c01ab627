#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/archive/clips.h"
#include "core/archive/sidecar.h"
#include "core/video/recorder_names.h"

namespace vvr::archive {

/// The files in an archive's folder of pictures that belong to the archive.
struct Outputs {
    std::vector<Sidecar> sidecars;              ///< by path
    std::vector<ScanProblem> problems;          ///< what is named as a sidecar and can't be read, below the folder
    std::vector<std::filesystem::path> claims;  ///< files of claims, of running or of killed programs
};

/// \param in the folder of clips; skipped if it is inside `out`
/// \throws Error io
Outputs list_outputs(const std::filesystem::path& out, const std::filesystem::path& in);

/// Removes the files and claims of killed programs that no later run would finish. Neither the index nor files of other
/// clips are removed.
void tidy(const std::filesystem::path& out, const Outputs& outputs);

/// The folder in which the files of a clip are made, beside where they will stand. It is hidden, and there only as long
/// as somebody makes them.
std::filesystem::path staging_of(const std::filesystem::path& out, const std::string& clip);

/// Removes such a folder with all that is in it. A link in its place goes, and not what it leads to.
void remove_staging(const std::filesystem::path& staging);

/// The names of all files that are written for a clip; for the index, its own name.
std::vector<std::string> written_names(const std::string& file_name);

/// Whether it is certain that there is no such file. Without permission to look, it is not.
bool is_gone(const std::filesystem::path& path);

/// What is there of an archive's clips, whatever a run leaves out of them.
struct Present {
    Scan scan;
    std::set<std::string> days;     ///< where the files of camera days stand of which a clip is there
    std::set<std::string> cameras;  ///< of which a clip is there
};

/// Looks at all clips. That one is still being written, excluded or of a time that can't be makes none of them gone.
/// \throws Error io when the folder can't be read
Present find_present(const std::filesystem::path& in, const std::filesystem::path& out, const ClipNames& names,
                     const video::RecorderNames& recorders);

/// Whether a clip, or all clips of a day, have gone for certain.
enum class SourceState {
    there,    ///< one is there, or nobody can say
    gone,     ///< each has gone, and what held it is there
    away,     ///< what held one is empty, leads nowhere or is not there: it may be a disk that is not mounted
    unknown,  ///< of a day whose sidecar does not tell its clips
};

struct SourceStatus {
    SourceState fate = SourceState::there;
    std::string folder;  ///< below `in`: what is away
};

SourceStatus source_state_of(const std::filesystem::path& in, const Sidecar& sidecar, const Present& present,
                             const video::RecorderNames& recorders);

/// Refuses to prune where it can't be known what has gone.
/// \throws Error io when there is no clip at all, or a part of the folder could not be read
void check_can_prune(const std::filesystem::path& in, const Present& present);

}  // namespace vvr::archive
