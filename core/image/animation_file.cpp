#include "core/image/animation_file.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/ending.h"
#include "core/base/error.h"
#include "core/image/atomic_file.h"

namespace vvr::image {

namespace {

/// One kind of animated file. The first of its encoders that the installed libav has is used.
struct Format {
    std::string_view ending;
    const char* muxer;
    std::array<const char*, 2> encoders;
    bool palette;
    const char* quality;  ///< libav's options
};

constexpr std::array formats{
    Format{".gif", "gif", {"gif", "gif"}, true, "loop=0"},
    Format{".mp4", "mp4", {"libx264", "mpeg4"}, false, "crf=17,preset=medium,b=12000000,x264-params=log=-1"},
    Format{".webm", "webm", {"libvpx-vp9", "libvpx"}, false, "crf=20,b=12000000,cpu-used=4,deadline=good"},
};

/// \throws Error io when libav has none of the encoders
VideoFormat film_format(const std::filesystem::path& path) {
    const Format& format = *std::ranges::find(formats, extension_of(path), &Format::ending);
    const auto encoder = std::ranges::find_if(format.encoders, has_encoder);
    if (encoder != format.encoders.end()) return {format.muxer, *encoder, format.quality, format.palette};
    throw Error(ErrorKind::io,
                fmt::format("cannot write '{}': the installed libavcodec has no encoder {}; choose another ending, or "
                            "single pictures with a field: out.{{frame:4}}.png",
                            path.string(), fmt::join(format.encoders, " or ")));
}

}  // namespace

std::vector<std::string> animation_extensions() {
    std::vector<std::string> endings;
    for (const Format& format : formats) endings.emplace_back(format.ending);
    return endings;
}

bool is_animation(const std::filesystem::path& path) {
    return std::ranges::find(formats, extension_of(path), &Format::ending) != formats.end();
}

AnimationFile::AnimationFile(std::filesystem::path path, int rate) : path_(std::move(path)), rate_(rate) {
    if (!is_animation(path_)) {
        throw Error(ErrorKind::usage, fmt::format("cannot write '{}': an animated file ends in {}", path_.string(),
                                                  fmt::join(animation_extensions(), " ")));
    }
}

AnimationFile::~AnimationFile() = default;

void AnimationFile::add(const Picture& picture) {
    if (!encoder_) {
        encoder_ = std::make_unique<VideoEncoder>(film_format(path_), path_.string(), picture.pixels.size(), rate_,
                                                 rate_, rate_);
    }
    encoder_->add(picture, pictures_++);
}

void AnimationFile::close() {
    if (!encoder_) throw Error(ErrorKind::io, fmt::format("cannot write '{}': there are no pictures", path_.string()));
    replace_file(path_, encoder_->finish());
    encoder_.reset();
}

}  // namespace vvr::image
