#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/workers/worker.h"
#include "core/archive/claim.h"
#include "core/archive/days.h"
#include "core/archive/verdict.h"
#include "core/error.h"

namespace vvr {

/// What all clips of a run have in common.
struct ArchiveJob {
    std::filesystem::path in;
    std::filesystem::path out;
    ArchiveRules rules;
    std::vector<std::string> options;  ///< that workers are given as they stand
    WorkerLimits limits;
    std::shared_ptr<const Sandbox> sandbox{};  ///< for workers
    int threads = 1;                           ///< a worker
    std::map<std::string, CameraDay> days{};   ///< by where their files stand
};

/// One clip's turn: nobody else writes its files as long as this is there.
class ClipTurn {
  public:
    /// Nothing when another program has the clip, or has done it meanwhile, or it has gone.
    /// \throws Error io
    static std::optional<ClipTurn> take(const ArchiveJob& job, const std::string& path);

    ClipTurn(ClipTurn&&) = default;
    ClipTurn& operator=(ClipTurn&&) = delete;
    ~ClipTurn();

    /// The worker that draws the clip.
    std::unique_ptr<Worker> start() const;

    /// Writes down what came of it, and removes what is no longer true.
    /// \param counts whether a failure counts as a try; not when it may be the machine's
    /// \throws Error io when that can't be done for this clip
    /// \throws Error when it was not the clip's fault, and the next clip would fare no better: io for a full disk
    Sidecar finish(const WorkerEnd& end, bool counts);

  private:
    ClipTurn(const ArchiveJob& job, Clip clip, std::optional<Sidecar> before, Claim claim);

    std::filesystem::path folder() const;
    std::string file_name() const;
    const CameraDay* day() const;

    const ArchiveJob* job_;
    Clip clip_;
    std::optional<Sidecar> before_;
    Claim claim_;
    bool finished_ = false;
};

/// Whether a worker ended because it could not draw, which is no clip's fault unless others can be drawn.
bool could_not_draw(const WorkerEnd& end);

/// Whether an error is that of a full disk, by its text.
bool is_disk_full(const std::string& text);

}  // namespace vvr
