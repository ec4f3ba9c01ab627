#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
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
    /// \param write_at takes the bytes, and outlives this; empty = they are kept in memory
    /// \throws Error io when libav can't
    VideoEncoder(const VideoFormat& format, const std::string& name, Size size, int ticks, int rate, int key_frames,
                 WriteAt write_at = {});
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

/// Endings of the animated files that can be written, with their dots.
std::vector<std::string> animation_extensions();

/// Whether a name ends like an animated file.
bool is_animation(const std::filesystem::path& path);

/// Pictures of one size as an animated file. The encoded file is held in memory and replaces `path` as a whole, as a
/// picture does. GIFs run in an endless loop, with a palette made from the first picture. Videos have even sides: an
/// odd last row or column is dropped. Same pictures, same bytes.
class AnimationFile {
  public:
    /// \param rate pictures per second
    /// \throws Error usage for another ending, io when libav has no encoder for it
    AnimationFile(std::filesystem::path path, int rate);
    ~AnimationFile();
    AnimationFile(const AnimationFile&) = delete;
    AnimationFile& operator=(const AnimationFile&) = delete;

    /// \throws Error io when it can't be encoded
    void add(const Picture& picture);

    /// Writes the file. Without this call there is none.
    /// \throws Error io
    void close();

  private:
    std::filesystem::path path_;
    int rate_;
    std::unique_ptr<VideoEncoder> encoder_;  ///< from the first picture on
    std::int64_t pictures_ = 0;
};

}  // namespace vvr::image
