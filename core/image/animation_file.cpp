#include "core/image/animation_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

#include "core/error.h"
#include "core/image/atomic_file.h"
#include "core/image/palette.h"

namespace vvr {

namespace {

/// One kind of animated file. Of its encoders the first that the installed libav has is taken.
struct Format {
    std::string_view ending;
    const char* muxer;
    std::array<const char*, 2> encoders;
    AVPixelFormat pixels;
    const char* quality;  ///< libav's options
};

constexpr std::array formats{
    Format{".gif", "gif", {"gif", "gif"}, AV_PIX_FMT_PAL8, "loop=0"},
    Format{
        ".mp4", "mp4", {"libx264", "mpeg4"}, AV_PIX_FMT_YUV420P, "crf=17,preset=medium,b=12000000,x264-params=log=-1"},
    Format{".webm", "webm", {"libvpx-vp9", "libvpx"}, AV_PIX_FMT_YUV420P, "crf=20,b=12000000,cpu-used=4,deadline=good"},
};

std::string lower_ending(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

struct Free {
    void operator()(AVFormatContext* context) const { avformat_free_context(context); }
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(SwsContext* context) const { sws_freeContext(context); }
    void operator()(AVIOContext* context) const {
        av_freep(&context->buffer);
        avio_context_free(&context);
    }
};
template <class T>
using Ptr = std::unique_ptr<T, Free>;

/// A file in memory, as libav's muxers want one.
struct MemoryFile {
    std::vector<std::byte> bytes;
    std::size_t at = 0;

    static int write(void* opaque, std::uint8_t* from, int size) {
        auto& file = *static_cast<MemoryFile*>(opaque);
        const auto count = static_cast<std::size_t>(size);
        file.bytes.resize(std::max(file.bytes.size(), file.at + count));
        std::memcpy(file.bytes.data() + file.at, from, count);
        file.at += count;
        return size;
    }

    static std::int64_t seek(void* opaque, std::int64_t offset, int whence) {
        auto& file = *static_cast<MemoryFile*>(opaque);
        const auto size = static_cast<std::int64_t>(file.bytes.size());
        if (whence == AVSEEK_SIZE) return size;
        const std::int64_t base = whence == SEEK_SET   ? 0
                                  : whence == SEEK_CUR ? static_cast<std::int64_t>(file.at)
                                                       : size;
        if (base + offset < 0 || base + offset > size) return AVERROR(EINVAL);
        file.at = static_cast<std::size_t>(base + offset);
        return base + offset;
    }
};

}  // namespace

struct AnimationFile::Encoder {
    Encoder(const Format& kind, std::string file_name, Size picture_size, int rate)
        : name(std::move(file_name)), size(kind.pixels == AV_PIX_FMT_PAL8 ? picture_size : even(picture_size)) {
        constexpr int buffer_size = 1 << 16;
        io.reset(avio_alloc_context(static_cast<unsigned char*>(av_malloc(buffer_size)), buffer_size, 1, &file, nullptr,
                                    &MemoryFile::write, &MemoryFile::seek));
        AVFormatContext* made = nullptr;
        check(avformat_alloc_output_context2(&made, nullptr, kind.muxer, nullptr));
        container.reset(made);
        container->pb = io.get();
        container->flags |= AVFMT_FLAG_BITEXACT;  // no version, no random number

        const AVCodec* codec = nullptr;
        for (const char* encoder : kind.encoders) {
            if (!codec) codec = avcodec_find_encoder_by_name(encoder);
        }
        if (!codec) {
            throw Error(ErrorKind::io,
                        fmt::format("cannot write '{}': the installed libavcodec has no encoder {}; choose "
                                    "another ending, or single pictures with a field: out.{{frame:4}}.png",
                                    name, fmt::join(kind.encoders, " or ")));
        }
        context.reset(avcodec_alloc_context3(codec));
        context->width = size.width;
        context->height = size.height;
        context->pix_fmt = kind.pixels;
        context->time_base = {1, rate};
        context->framerate = {rate, 1};
        context->gop_size = rate;
        context->thread_count = 1;  // encoders give other bytes with other counts
        context->flags |= AV_CODEC_FLAG_BITEXACT;
        context->log_level_offset = 1000;  // what encoders tell is not for our stderr
        if ((container->oformat->flags & AVFMT_GLOBALHEADER) != 0) context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        AVDictionary* options = nullptr;
        av_dict_parse_string(&options, kind.quality, "=", ",", 0);
        const int opened = avcodec_open2(context.get(), codec, &options);
        stream = avformat_new_stream(container.get(), nullptr);
        const int described =
            stream ? avcodec_parameters_from_context(stream->codecpar, context.get()) : AVERROR(ENOMEM);
        if (stream) stream->time_base = context->time_base;
        const int begun = opened < 0 || described < 0 ? 0 : avformat_write_header(container.get(), &options);
        av_dict_free(&options);
        for (const int result : {opened, described, begun}) check(result);

        packet.reset(av_packet_alloc());
        frame.reset(av_frame_alloc());
        frame->format = kind.pixels;
        frame->width = size.width;
        frame->height = size.height;
        check(av_frame_get_buffer(frame.get(), 0));
    }

    static Size even(Size size) { return {std::max(2, size.width & ~1), std::max(2, size.height & ~1)}; }

    void check(int result) const {
        if (result >= 0) return;
        std::array<char, AV_ERROR_MAX_STRING_SIZE> words{};
        av_strerror(result, words.data(), words.size());
        throw Error(ErrorKind::io, fmt::format("cannot encode '{}': {}", name, words.data()));
    }

    void add(const Picture& picture) {
        check(av_frame_make_writable(frame.get()));
        if (frame->format == AV_PIX_FMT_PAL8) {
            paint_palette(picture);
        } else {
            paint_yuv(picture);
        }
        frame->pts = pictures++;
        check(avcodec_send_frame(context.get(), frame.get()));
        drain();
    }

    void finish() {
        check(avcodec_send_frame(context.get(), nullptr));
        drain();
        check(av_write_trailer(container.get()));
        avio_flush(io.get());
    }

    void paint_palette(const Picture& picture) {
        if (!palette) {
            palette.emplace(picture);
            std::array<std::uint32_t, 256> words{};
            for (std::size_t i = 0; i < palette->colours().size(); ++i) {
                const auto [red, green, blue] = palette->colours()[i];
                words[i] = 0xFF000000U | static_cast<std::uint32_t>(red << 16 | green << 8 | blue);
            }
            std::memcpy(frame->data[1], words.data(), sizeof(words));
        }
        for (int j = 0; j < size.height; ++j) {
            std::ranges::transform(picture.pixels.row(j), frame->data[0] + std::ptrdiff_t{j} * frame->linesize[0],
                                   [this](const Rgba& pixel) { return palette->nearest(pixel); });
        }
    }

    void paint_yuv(const Picture& picture) {
        Plane<std::array<std::uint8_t, 3>> rgb(size);
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                // One row or column of less than two pixels stands twice.
                const Rgba& pixel = picture.pixels.at(std::min(i, picture.pixels.width() - 1),
                                                      std::min(j, picture.pixels.height() - 1));
                for (std::size_t c = 0; c < 3; ++c) {
                    rgb.at(i, j)[c] = static_cast<std::uint8_t>(255 * std::clamp(pixel[c], 0.0F, 1.0F) + 0.5F);
                }
            }
        }
        if (!scaler) {
            scaler.reset(sws_getContext(size.width, size.height, AV_PIX_FMT_RGB24, size.width, size.height,
                                        AV_PIX_FMT_YUV420P, SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP,
                                        nullptr, nullptr, nullptr));
            check(scaler ? 0 : AVERROR(ENOMEM));
        }
        const std::array<const std::uint8_t*, 1> from = {rgb.pixels().front().data()};
        const std::array<int, 1> stride = {3 * size.width};
        sws_scale(scaler.get(), from.data(), stride.data(), 0, size.height, frame->data, frame->linesize);
    }

    /// Passes on what the encoder has ready.
    void drain() {
        for (;;) {
            const int result = avcodec_receive_packet(context.get(), packet.get());
            if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
            check(result);
            av_packet_rescale_ts(packet.get(), context->time_base, stream->time_base);
            packet->duration = av_rescale_q(1, context->time_base, stream->time_base);
            packet->stream_index = stream->index;
            check(av_interleaved_write_frame(container.get(), packet.get()));
        }
    }

    std::string name;
    Size size;
    MemoryFile file;
    Ptr<AVIOContext> io;
    Ptr<AVFormatContext> container;
    Ptr<AVCodecContext> context;
    AVStream* stream = nullptr;  ///< the container's
    Ptr<AVPacket> packet;
    Ptr<AVFrame> frame;
    Ptr<SwsContext> scaler;
    std::optional<Palette> palette;
    std::int64_t pictures = 0;
};

std::vector<std::string> animation_endings() {
    std::vector<std::string> endings;
    for (const Format& format : formats) endings.emplace_back(format.ending);
    return endings;
}

bool is_animation(const std::filesystem::path& path) {
    return std::ranges::find(formats, lower_ending(path), &Format::ending) != formats.end();
}

AnimationFile::AnimationFile(std::filesystem::path path, int rate) : path_(std::move(path)), rate_(rate) {
    if (!is_animation(path_)) {
        throw Error(ErrorKind::usage, fmt::format("cannot write '{}': an animated file ends in {}", path_.string(),
                                                  fmt::join(animation_endings(), " ")));
    }
}

AnimationFile::~AnimationFile() = default;
AnimationFile::AnimationFile(AnimationFile&&) noexcept = default;
AnimationFile& AnimationFile::operator=(AnimationFile&&) noexcept = default;

void AnimationFile::add(const Picture& picture) {
    if (!encoder_) {
        const auto format = std::ranges::find(formats, lower_ending(path_), &Format::ending);
        encoder_ = std::make_unique<Encoder>(*format, path_.string(), picture.pixels.size(), rate_);
    }
    encoder_->add(picture);
}

void AnimationFile::close() {
    if (!encoder_) throw Error(ErrorKind::io, fmt::format("cannot write '{}': there are no pictures", path_.string()));
    encoder_->finish();
    replace_file(path_, encoder_->file.bytes);
    encoder_.reset();
}

}  // namespace vvr
