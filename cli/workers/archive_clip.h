#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/signals.h"
#include "cli/workers/worker.h"
#include "core/archive/claim.h"
#include "core/archive/clips.h"
#include "core/archive/verdict.h"
#include "core/base/error.h"
#include "core/video/recorder_names.h"

namespace vvr::workers {

/// What all clips of a run have in common.
struct ArchiveJob {
    std::filesystem::path in;
    std::filesystem::path out;
    archive::ArchiveRules rules;
    Settings settings;    ///< that workers are given as they stand
    Settings drawn_with;  ///< those of them that choose OpenGL
    WorkerLimits limits;
    std::shared_ptr<const Sandbox> sandbox{};          ///< for workers
    int threads = 1;                                   ///< a worker
    std::map<std::string, archive::CameraDay> days{};  ///< by where their files stand
    video::RecorderNames names{};                      ///< how clips' names tell their camera
};

/// One clip's turn: nobody else writes its files as long as this is there.
class ClipTask {
  public:
    /// Nothing when another program has the clip, or has done it meanwhile, or it has gone.
    /// \throws Error io
    static std::optional<ClipTask> take(const ArchiveJob& job, const std::string& path);

    ClipTask(ClipTask&&) = default;
    ClipTask& operator=(ClipTask&&) = delete;
    ~ClipTask();

    /// The worker that draws the clip.
    std::unique_ptr<Worker> start() const;

    /// Puts the clip's files in their places once all of them are there, and writes down what came of it. Where it
    /// failed, the files that are there stay, and the sidecar says what they show.
    /// \param signals that wait while something is written
    /// \throws Error io when that can't be done for this clip
    /// \throws Error when it was not the clip's fault, and the next clip would fare no better: io for a full disk,
    /// limit when no worker can be started
    archive::Sidecar finish(const WorkerResult& end, cli::Signals& signals);

  private:
    ClipTask(const ArchiveJob& job, archive::Clip clip, std::optional<archive::Sidecar> before,
             archive::LockFile claim);

    std::filesystem::path folder() const;
    std::filesystem::path staging() const;
    std::filesystem::path staged(archive::OutputKind kind) const;
    std::string file_name() const;
    archive::Sidecar read_results(const WorkerResult& end) const;
    archive::Sidecar failure(int status, ErrorCode code, const std::string& reason, double seconds) const;
    const archive::CameraDay* day() const;
    std::string camera() const;

    const ArchiveJob* job_;
    archive::Clip clip_;
    std::optional<archive::Sidecar> before_;
    archive::LockFile lock_;
    bool finished_ = false;
};

/// Whether a worker says that it could not draw, which may be no clip's fault: see start_drawing_test.
bool could_not_draw(const WorkerResult& end);

/// A worker that reads no clip, and ends with 0 where workers can draw.
std::unique_ptr<Worker> start_drawing_test(const ArchiveJob& job);

/// What a worker told of its run, for people; where it told nothing, what it said last.
std::string words_of(const WorkerResult& end);

/// Whether an error is about one file, so that others may still fare well: io, but no full disk.
bool is_of_one_file(const Error& error);

}  // namespace vvr::workers
