#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/av_writer.h"
#include "core/image/picture.h"

namespace vvr::image {

/// How libav encodes a film.
struct VideoFormat {
    std::string muxer;
    std::string encoder;
    std::string options;   ///< libav's, of the encoder and the muxer: "crf=17,preset=medium"
    bool palette = false;  ///< 256 colours, made from the first picture
    std::vector<std::pair<std::string, std::string>> tags{};  ///< of the container: libav's keys, and what they say
};

/// Whether the installed libav has an encoder.
bool has_encoder(const std::string& encoder);

/// Pictures of one size as a film, in memory or in a file. Films with a palette keep the size, others have even sides:
/// an odd last row or column is dropped. Same pictures, same bytes.
class VideoEncoder {
  public:
    /// \param name for messages
    /// \param ticks unit of times, per second
    /// \param rate pictures per second, about
    /// \param key_frames pictures from one key frame to the next
    /// \throws Error io when libav can't
    VideoEncoder(const VideoFormat& format, const std::string& name, Size size, int ticks, int rate, int key_frames);

    /// The same with a file that takes the bytes; it outlives this.
    VideoEncoder(const VideoFormat& format, const std::string& name, Size size, int ticks, int rate, int key_frames,
                WriteAt write_at);
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// \param time in ticks, later than that of the picture before
    /// \throws Error io when it can't be encoded
    void add(const Picture& picture, std::int64_t time);

    /// The same for a film without a palette.
    void add(const Plane<Bgr>& picture, std::int64_t time);

    /// Size so far.
    std::size_t bytes() const;

    /// The whole file; empty where it went elsewhere. Call it once, after the last picture.
    /// \throws Error io
    std::vector<std::byte> finish();

  private:
    struct Parts;

    std::unique_ptr<Parts> parts_;
};

}  // namespace vvr::image
