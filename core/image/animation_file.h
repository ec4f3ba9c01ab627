#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/image/film_encoder.h"
#include "core/image/picture.h"

namespace vvr::image {

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
