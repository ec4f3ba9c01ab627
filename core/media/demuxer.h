#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/media/av.h"
#include "core/media/input.h"
#include "core/media/stamp_mender.h"

// Playlists (such as HLS) name other files, so they are read only from servers. For local files, a folder, a glob or a
// list of vvr's own does the same, and stays within its folder.
namespace vvr::media {

/// Whether the file name has a playlist's extension.
bool is_playlist_name(const std::string& name);

/// Whether the format is a playlist, whose files name other files.
bool is_playlist_format(const AVInputFormat& format);

/// Presentation timestamp of a packet, or else its decoding timestamp; AV_NOPTS_VALUE if it has neither.
std::int64_t stamp_of(const AVPacket& packet);

/// A stream's type and codec, such as "audio (aac)".
std::string name_of(const AVStream& stream);

/// Frames per second of inputs without timestamps that state no rate.
inline constexpr double assumed_rate = 25;

/// \throws Error stream_timeout
[[noreturn]] void throw_timeout(const Input& input);

/// Reads the packets of a container's video stream.
class Demuxer {
  public:
    enum class Kind {
        video,    ///< anything with a video stream
        picture,  ///< a file with one picture; its format must be a picture format
    };

    /// \param rate frames per second in place of what the input states; 0 = as it states, or else `assumed_rate`. Of a
    ///        live stream only if it states none
    /// \throws Error io if the input can't be opened, not_video if it has no video stream, limit if its pictures are
    ///         too large
    Demuxer(const Input& input, Kind kind, double rate);

    /// Reads the next packet of the video stream, skipping errors. False at the end.
    bool read(AVPacket& packet);

    /// Makes `read_any` return the packets of all streams, not only the video stream.
    void select_all_streams();

    /// Reads the next packet of any selected stream, skipping errors. False at the end. Timestamps of files are mended.
    bool read_any(AVPacket& packet);

    /// The frames so far whose timestamps were mended.
    MendedFrames mended() const;

    AVFormatContext& format() const { return *format_; }
    AVStream& stream() const { return *stream_; }
    av::Log& log() { return log_; }

    /// Reads that failed so far.
    std::int64_t damaged() const { return damaged_; }

    /// Converts a timestamp to seconds on the container's clock. Empty if the timestamp is missing.
    std::optional<double> seconds(std::int64_t stamp) const;

    /// Average seconds per frame according to the container without frames a tick apart, or 1/25 if unknown.
    double frame_duration() const;

    /// One unit of the timestamps, seconds.
    double tick() const;

    /// Seconds per second of the container's clock: other than 1 if the user gives a rate.
    double stretch() const { return stretch_; }

    /// Seconds that the container's duration lacks, because it has frames a tick apart.
    double lacking() const { return lacking_ * stretch_; }

    /// How many video tracks there are, and which of them is read, from 1.
    int tracks() const { return static_cast<int>(tracks_.size()); }
    int track() const;

  private:
    int open(const Input& input, double rate, const std::string& rtsp_flags);
    void choose_stream(const Input& input, Kind kind);
    bool read_unmended(AVPacket& packet);

    av::Log log_;
    std::unique_ptr<FileReader> reader_;
    std::unique_ptr<PipeReader> pipe_;
    std::shared_ptr<Watchdog> watchdog_;  ///< live streams only
    av::Ptr<AVFormatContext> format_;
    std::vector<AVStream*> tracks_;  ///< of video, without cover pictures
    double stretch_ = 1;
    double lacking_ = 0;  ///< seconds on the container's clock
    std::optional<StampMender> mender_;
    AVStream* stream_ = nullptr;
    std::int64_t damaged_ = 0;
};

}  // namespace vvr::media
