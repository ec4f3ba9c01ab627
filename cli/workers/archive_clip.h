#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/signals.h"
#include "cli/workers/worker.h"
#include "core/archive/clips.h"
#include "core/archive/need.h"
#include "core/base/error.h"
#include "core/base/lock_file.h"
#include "core/footage/recorder_names.h"
#include "core/tracking/event_line.h"

namespace vvr::workers {

/// What the pictures of a camera, or of all cameras, are drawn with.
struct PictureSettings {
    Settings settings;               ///< passed on to workers unchanged
    std::vector<std::string> names;  ///< name patterns, tried before the built-in ones
    std::string digest;              ///< identifies all settings that change pictures
};

/// What all clips of a run have in common.
struct ArchiveJob {
    std::filesystem::path in;
    std::filesystem::path out;
    archive::ArchiveRules rules;
    PictureSettings pictures;
    std::map<std::string, PictureSettings> of_cameras{};  ///< for cameras with settings of their own
    Settings drawn_with;                                  ///< the options that select OpenGL and the decoder
    WorkerLimits limits;
    std::shared_ptr<const Sandbox> sandbox{};          ///< for workers
    std::optional<double> pieces_margin{};             ///< seconds around each kept event; none = events aren't kept
    int threads = 1;                                   ///< per worker
    bool reports_events = false;                       ///< new events are reported
    std::map<std::string, archive::CameraDay> days{};  ///< by the path that names their files
    footage::RecorderNames names{};                    ///< how to read the camera and time from a clip's name

    const archive::CameraDay* day_of(const std::string& path) const;

    /// The camera of a clip or a day.
    std::string camera_of(const std::string& path) const;

    const PictureSettings& pictures_of(const std::string& path) const;

    /// Whether and why a clip or a day is to be drawn.
    archive::Need need_of(const archive::Clip& clip, const std::optional<archive::Sidecar>& sidecar) const;
};

/// A clip that is being drawn. It holds the lock of the clip's files.
class ClipTask {
  public:
    /// Nothing if another program has the clip, if it is already done, or if it no longer exists.
    /// \throws Error io, also if the clip can't be opened
    static std::optional<ClipTask> take(const ArchiveJob& job, const std::string& path);

    ClipTask(ClipTask&&) = default;
    ClipTask& operator=(ClipTask&&) = delete;
    ClipTask(const ClipTask&) = delete;
    ClipTask& operator=(const ClipTask&) = delete;
    ~ClipTask();

    /// Starts the worker that draws the clip.
    std::unique_ptr<Worker> start() const;

    /// Moves the clip's files from the staging folder to their places and writes the sidecar. After a failure the older
    /// files stay, and the sidecar says what they show.
    /// \param signals held back during the writing
    /// \throws Error io if only this clip is affected
    /// \throws Error when every other clip would fail too: io for a full disk, limit when no worker can start
    archive::Sidecar finish(const WorkerResult& end, cli::Signals& signals);

    /// After `finish`: the events that no earlier run has reported, if they are to be reported.
    const std::vector<tracking::EventLine>& new_events() const { return new_events_; }

  private:
    ClipTask(const ArchiveJob& job, archive::Clip clip, std::optional<archive::Sidecar> before, LockFile claim);

    std::filesystem::path folder() const;
    std::filesystem::path staging() const;
    std::filesystem::path staged(archive::OutputKind kind) const;
    std::filesystem::path staged_pieces() const;
    std::string file_name() const;
    archive::Sidecar read_results(const WorkerResult& end) const;
    std::vector<tracking::EventLine> find_new_events(const archive::Sidecar& sidecar) const;
    int earlier_tries() const;
    bool is_outside(const WorkerResult& end) const;
    void add_older_pieces(archive::Sidecar& sidecar) const;
    archive::Sidecar failure(int status, ErrorCode code, const std::string& reason, double seconds) const;
    const archive::CameraDay* day() const;
    std::string camera() const;

    const ArchiveJob* job_;
    archive::Clip clip_;
    std::optional<archive::Sidecar> before_;
    LockFile lock_;
    std::vector<tracking::EventLine> new_events_;
    bool report_moved_ = false;
    bool finished_ = false;
};

/// For a warning about clips that are on the day of their last modification: what their names, or containers, lack.
std::string_view lacks_time(const archive::DayRule& rule);

/// Starts a worker that reads no clip. Its exit status is 0 if workers can draw.
std::unique_ptr<Worker> start_drawing_test(const ArchiveJob& job);

/// Whether an error concerns one file only: io, but not a full disk.
bool affects_one_file(const Error& error);

}  // namespace vvr::workers
