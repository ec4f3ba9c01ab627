#include "core/image/video_encoder.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/av_muxer.h"
#include "core/base/error.h"
#include "core/base/file.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libswscale/swscale.h>
}

namespace vvr::image {

namespace {

/// x264's own options. Its AVX-512 code reads uninitialised memory, so its output is not deterministic (x264 164).
/// Therefore processors with AVX-512 use the AVX2 code. On other processors, requesting AVX2 could crash.
const char* x264_settings() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512bw")) return "log=-1:asm=AVX2";
#endif
    return "log=-1";
}

/// Writes a file to memory.
WriteAt into(std::vector<std::byte>& file) {
    return [&file](std::int64_t offset, std::span<const std::byte> bytes) {
        const auto at = static_cast<std::size_t>(offset);
        file.resize(std::max(file.size(), at + bytes.size()));
        std::ranges::copy(bytes, file.begin() + offset);
    };
}

}  // namespace

struct VideoEncoder::Parts {
    Parts(const VideoRow& row, const std::string& settings, std::string file_name, Size picture_size, int ticks,
          int rate, int key_frames)
        : name(std::move(file_name)),
          size(row.palette ? picture_size : even(picture_size)),
          muxer(row.muxer, into(memory), [this](const char*, int code) { fail(code); }) {
        const AVPixelFormat pixels = row.palette ? AV_PIX_FMT_PAL8 : AV_PIX_FMT_YUV420P;
        AVFormatContext& container = muxer.format();
        const AVCodec* codec = avcodec_find_encoder_by_name(row.encoder);
        check(codec ? 0 : AVERROR_ENCODER_NOT_FOUND);
        context.reset(avcodec_alloc_context3(codec));
        context->width = size.width;
        context->height = size.height;
        context->pix_fmt = pixels;
        context->time_base = {1, ticks};
        context->framerate = {rate, 1};
        context->gop_size = key_frames;
        context->thread_count = 1;  // the output depends on the number of threads
        context->flags |= AV_CODEC_FLAG_BITEXACT;
        context->log_level_offset = 1000;  // keep encoders' messages off stderr
        if ((container.oformat->flags & AVFMT_GLOBALHEADER) != 0) context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        AVDictionary* options = nullptr;
        av_dict_parse_string(&options, settings.c_str(), "=", ",", 0);
        if (std::string_view(row.encoder) == "libx264") av_dict_set(&options, "x264-params", x264_settings(), 0);
        const int opened = avcodec_open2(context.get(), codec, &options);
        stream = avformat_new_stream(&container, nullptr);
        const int described =
            stream ? avcodec_parameters_from_context(stream->codecpar, context.get()) : AVERROR(ENOMEM);
        if (stream) stream->time_base = context->time_base;
        const int begun = opened < 0 || described < 0 ? 0 : muxer.begin(&options);
        av_dict_free(&options);
        for (const int result : {opened, described, begun}) check(result);

        packet.reset(av_packet_alloc());
        frame.reset(av_frame_alloc());
        frame->format = pixels;
        frame->width = size.width;
        frame->height = size.height;
        check(av_frame_get_buffer(frame.get(), 0));
        // Encoders read beyond the ends of rows, so the padding must be deterministic.
        for (const AVBufferRef* const buffer : frame->buf) {
            if (buffer != nullptr) std::memset(buffer->data, 0, buffer->size);
        }
    }

    static Size even(Size size) { return {std::max(2, size.width & ~1), std::max(2, size.height & ~1)}; }

    void check(int result) const { muxer.check("encode", result); }

    [[noreturn]] void fail(int result) const {
        throw Error(ErrorCode::io, fmt::format("cannot encode '{}': {}", name, av_error_text(result)));
    }

    void add(const Picture& picture, std::int64_t time) {
        check(av_frame_make_writable(frame.get()));
        if (frame->format == AV_PIX_FMT_PAL8) {
            paint_palette(picture);
        } else {
            paint(bytes_of(picture));
        }
        encode(time);
    }

    void encode(std::int64_t time) {
        duration = frame->pts == AV_NOPTS_VALUE ? 1 : time - frame->pts;
        frame->pts = time;
        frame->pict_type = AV_PICTURE_TYPE_NONE;
        check(avcodec_send_frame(context.get(), frame.get()));
        drain();
    }

    void finish() {
        check(avcodec_send_frame(context.get(), nullptr));
        drain();
        muxer.close();
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

    static Plane<Bgr> bytes_of(const Picture& picture) {
        Plane<Bgr> bytes(picture.pixels.size());
        std::ranges::transform(picture.pixels.pixels(), bytes.pixels().begin(), [](const Rgba& pixel) {
            return Bgr{to_byte(pixel.b), to_byte(pixel.g), to_byte(pixel.r)};
        });
        return bytes;
    }

    void paint(const Plane<Bgr>& picture) {
        // One extra row, because libswscale reads up to 16 bytes past the end of the last row.
        auto bgr = Plane<Bgr>::for_overwrite({size.width, size.height + 1});
        const int wide = std::min(size.width, picture.width());
        for (int j = 0; j <= size.height; ++j) {
            // Repeats a single row or column.
            const std::span<const Bgr> row = picture.row(std::min(j, picture.height() - 1));
            const auto rest = std::ranges::copy(row.first(static_cast<std::size_t>(wide)), bgr.row(j).begin()).out;
            std::fill(rest, bgr.row(j).end(), row.back());
        }
        if (!scaler) {
            scaler.reset(sws_getContext(
                size.width, size.height, AV_PIX_FMT_BGR24, size.width, size.height, AV_PIX_FMT_YUV420P,
                SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INP, nullptr, nullptr, nullptr));
            check(scaler ? 0 : AVERROR(ENOMEM));
        }
        const std::array<const std::uint8_t*, 1> from = {bgr.pixels().front().data()};
        const std::array<int, 1> stride = {3 * size.width};
        sws_scale(scaler.get(), from.data(), stride.data(), 0, size.height, frame->data, frame->linesize);
    }

    /// Writes the encoder's available packets to the container.
    void drain() {
        for (;;) {
            const int result = avcodec_receive_packet(context.get(), packet.get());
            if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
            check(result);
            av_packet_rescale_ts(packet.get(), context->time_base, stream->time_base);
            packet->duration = av_rescale_q(duration, context->time_base, stream->time_base);
            packet->stream_index = stream->index;
            muxer.add(*packet);
        }
    }

    std::string name;
    Size size;
    std::vector<std::byte> memory;  ///< the file
    AvMuxer muxer;
    AvPtr<AVCodecContext> context;
    AVStream* stream = nullptr;  ///< the muxer's
    AvPtr<AVPacket> packet;
    AvPtr<AVFrame> frame;
    AvPtr<SwsContext> scaler;
    std::optional<Palette> palette;
    std::int64_t duration = 1;  ///< ticks; of the last but one picture, and also used for the last
};

bool has_encoder(const std::string& encoder) {
    return avcodec_find_encoder_by_name(encoder.c_str()) != nullptr;
}

VideoEncoder::VideoEncoder(const VideoRow& row, const std::string& options, const std::string& name, Size size,
                           int ticks, int rate, int key_frames)
    : parts_(std::make_unique<Parts>(row, options, name, size, ticks, rate, key_frames)) {}

VideoEncoder::~VideoEncoder() = default;

void VideoEncoder::add(const Picture& picture, std::int64_t time) {
    parts_->add(picture, time);
}

void VideoEncoder::add(const Plane<Bgr>& picture, std::int64_t time) {
    parts_->check(av_frame_make_writable(parts_->frame.get()));
    parts_->paint(picture);
    parts_->encode(time);
}

std::size_t VideoEncoder::bytes() const {
    return static_cast<std::size_t>(parts_->muxer.size());
}

std::vector<std::byte> VideoEncoder::finish() {
    parts_->finish();
    return std::move(parts_->memory);
}

std::span<const VideoRow> video_rows() {
    // The options of previews disable B-frames, so that every player shows the frames in order.
    static constexpr auto as_mp4 = "crf=17,preset=medium,b=12000000";
    static constexpr auto as_webm = "crf=20,b=12000000,cpu-used=4,deadline=good";
    static constexpr std::array rows{
        VideoRow{"gif", "gif", "loop=0", "", {}, true},
        VideoRow{"mp4", "libx264", as_mp4, "preset=veryfast,subq=1,motion-est=dia,bf=0", {29, 32}},
        VideoRow{"mp4", "mpeg4", as_mp4},
        VideoRow{"webm", "libvpx-vp9", as_webm, "cpu-used=6,deadline=realtime", {36, 40}},
        VideoRow{"webm", "libvpx", as_webm, "cpu-used=8,deadline=realtime", {22, 28}},
    };
    return rows;
}

namespace {

/// \throws Error io if libav has none of the encoders
const VideoRow& film_row(const std::filesystem::path& path) {
    std::vector<std::string_view> lacking;
    for (const VideoRow& row : video_rows()) {
        if (extension_of(path) != row.extension()) continue;
        if (has_encoder(row.encoder)) return row;
        lacking.emplace_back(row.encoder);
    }
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': libavcodec was built without the encoder {}; choose another file "
                            "extension, or write single pictures: out.{{frame:4}}.png",
                            path.string(), fmt::join(lacking, " or ")));
}

}  // namespace

std::vector<std::string> animation_extensions() {
    std::vector<std::string> extensions;
    for (const VideoRow& row : video_rows()) extensions.push_back(row.extension());
    extensions.erase(std::unique(extensions.begin(), extensions.end()), extensions.end());
    return extensions;
}

bool is_animation(const std::filesystem::path& path) {
    return std::ranges::find(video_rows(), extension_of(path), &VideoRow::extension) != video_rows().end();
}

AnimationFile::AnimationFile(std::filesystem::path path, int rate) : path_(std::move(path)), rate_(rate) {
    if (!is_animation(path_)) {
        throw Error(ErrorCode::output_format_unknown,
                    fmt::format("cannot write '{}': its file extension is not that of an animation; use one of: {}",
                                path_.string(), fmt::join(animation_extensions(), " ")));
    }
}

AnimationFile::~AnimationFile() = default;

void AnimationFile::add(const Picture& picture) {
    if (!encoder_) {
        const VideoRow& row = film_row(path_);
        encoder_ =
            std::make_unique<VideoEncoder>(row, row.film, path_.string(), picture.pixels.size(), rate_, rate_, rate_);
    }
    encoder_->add(picture, pictures_++);
}

void AnimationFile::close() {
    if (!encoder_)
        throw Error(ErrorCode::io,
                    fmt::format("cannot write '{}': the animation has no pictures; choose a longer part of the clip",
                                path_.string()));
    replace_file(path_, encoder_->finish());
    encoder_.reset();
}

}  // namespace vvr::image
