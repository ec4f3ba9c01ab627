#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/video/av.h"
#include "core/video/input.h"

// Files that name other files (HLS and the like) are read from servers alone. On this machine a folder, a pattern or a
// list of vvr's own says the same, and none of them leads anywhere else.
namespace vvr::video {

/// Whether a name is that of a playlist.
bool is_playlist_name(const std::string& name);

/// Whether files of a format name other files.
bool is_playlist_format(const AVInputFormat& format);

/// libav's names of all containers but those that name other files, as its `format_whitelist` wants them.
std::string formats_of_clips();

/// "audio (aac)"
std::string name_of(const AVStream& stream);

/// The packets of one video stream of a container.
class Demuxer {
  public:
    enum class Kind {
        video,    ///< anything with a video stream
        picture,  ///< a file that is one picture: the format has to be a picture's, and nothing is probed twice
    };

    /// \param rate frames per second for formats that carry no times
    /// \throws Error io when the input can't be opened, not_video when it has no video stream that can be decoded,
    ///         limit when its pictures are too large
    Demuxer(const Input& input, Kind kind, double rate);

    /// The next packet of the video stream, passing over errors; false at the end.
    bool read(AVPacket& packet);

    /// From now on `read_any` gives the packets of all streams, not those of the video stream alone.
    void select_all_streams();

    /// The next packet of any stream that is taken, passing over errors; false at the end.
    bool read_any(AVPacket& packet);

    AVFormatContext& format() const { return *format_; }
    AVStream& stream() const { return *stream_; }
    av::Log& log() { return log_; }

    /// Reads that failed so far.
    std::int64_t damaged() const { return damaged_; }

    /// Seconds on the container's own clock; nothing where the stamp is missing.
    std::optional<double> seconds(std::int64_t stamp) const;

    /// Average seconds per frame by the container; 1/25 where it has no average.
    double frame_duration() const;

  private:
    int open(const Input& input, double rate, const std::string& rtsp_flags);
    void choose_stream(const Input& input, Kind kind);

    av::Log log_;
    std::unique_ptr<FileReader> reader_;
    std::unique_ptr<PipeReader> pipe_;
    std::shared_ptr<Watchdog> watchdog_;  ///< of a live stream
    av::Ptr<AVFormatContext> format_;
    AVStream* stream_ = nullptr;
    std::int64_t damaged_ = 0;
};

}  // namespace vvr::video
