#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/image/picture.h"

namespace vvr::image {

/// A container, an encoder for it, and libav's options. The first whose encoder is installed is used.
struct VideoRow {
    const char* muxer;  ///< libav's name, also the file extension
    const char* encoder;
    const char* film;                  ///< options for animations
    const char* preview = "";          ///< options for small videos in pages; empty = no such videos
    std::array<int, 2> preview_crf{};  ///< constant rate factors for such videos, large and small; lower is better
    bool palette = false;              ///< 256 colours, chosen from the first picture

    std::string extension() const { return std::string(".") + muxer; }
};
std::span<const VideoRow> video_rows();

/// Whether the installed libav has an encoder.
bool has_encoder(const std::string& encoder);

/// Encodes pictures of one size as a video in memory. Unless the video has a palette, its sides are even:
/// an odd last row or column is dropped. The output is deterministic.
class VideoEncoder {
  public:
    /// \param options libav's options for encoder and muxer: "crf=17,preset=medium"
    /// \param name file name for messages
    /// \param ticks time base: ticks per second
    /// \param rate approximate pictures per second
    /// \param key_frames pictures per key frame
    /// \throws Error io if libav fails
    VideoEncoder(const VideoRow& row, const std::string& options, const std::string& name, Size size, int ticks,
                 int rate, int key_frames);
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// \param time ticks, greater than that of the previous picture
    /// \throws Error io if encoding fails
    void add(const Picture& picture, std::int64_t time);

    /// The same, for a video without a palette.
    void add(const Plane<Bgr>& picture, std::int64_t time);

    /// Bytes written so far.
    std::size_t bytes() const;

    /// Finishes the file and returns its bytes. Call it once, after the last picture.
    /// \throws Error io if encoding fails
    std::vector<std::byte> finish();

  private:
    struct Parts;

    std::unique_ptr<Parts> parts_;
};

/// The extensions of animations that can be written, with their dots.
std::vector<std::string> animation_extensions();

/// Whether a file name has the extension of an animation.
bool is_animation(const std::filesystem::path& path);

/// Writes pictures of one size as an animation. The encoded file is kept in memory and replaces `path` atomically. GIFs
/// loop forever, with a palette chosen from the first picture. Videos have even sides: an odd last row or column is
/// dropped. The output is deterministic.
class AnimationFile {
  public:
    /// \param rate pictures per second
    /// \throws Error usage for an unknown extension
    AnimationFile(std::filesystem::path path, int rate);
    ~AnimationFile();
    AnimationFile(const AnimationFile&) = delete;
    AnimationFile& operator=(const AnimationFile&) = delete;

    /// \throws Error io if encoding fails, or if libav has no encoder for the format
    void add(const Picture& picture);

    /// Writes the file. Without this call, no file is written.
    /// \throws Error io if it can't be written or has no pictures
    void close();

  private:
    std::filesystem::path path_;
    int rate_;
    std::unique_ptr<VideoEncoder> encoder_;  ///< created with the first picture
    std::int64_t pictures_ = 0;
};

}  // namespace vvr::image
