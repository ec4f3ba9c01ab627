#include "core/media/container.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"

extern "C" {
#include <libavutil/display.h>
#include <libavutil/parseutils.h>
}

namespace vvr::media {
namespace {

/// The size after rotation and with square pixels. The shorter side of a pixel is stretched, so no detail is lost.
/// \param shape of the whole picture, in place of the pixels' shape
Size shown_size(const AVFrame& frame, AVRational aspect, Orientation orientation, const std::optional<Aspect>& shape) {
    double width = frame.width;
    double height = frame.height;
    double ratio = aspect.num > 0 && aspect.den > 0 ? av_q2d(aspect) : 1;
    if (shape) {
        const double asked = static_cast<double>(shape->width) / shape->height;
        ratio = (orientation.transpose ? 1 / asked : asked) * height / width;
    }
    constexpr double plausible = 8;
    if (ratio > 1 && ratio < plausible) width *= ratio;
    if (ratio < 1 && ratio > 1 / plausible) height /= ratio;
    const Size size{static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height))};
    return orientation.transpose ? Size{size.height, size.width} : size;
}

/// The duration in the container, seconds; 0 = unknown.
double stated_duration(const AVFormatContext& format, const AVStream& stream) {
    const double tick = av_q2d(stream.time_base);
    double stated = static_cast<double>(stream.duration) * tick;
    constexpr double longest = 9.2e12;  // seconds; libav's maximum in microseconds
    if (stated <= 0 || stated >= longest) {
        stated = format.duration > 0 ? static_cast<double>(format.duration) / AV_TIME_BASE : 0;
    }
    // Matroska and WebM state the time of the end, even if the first frame is not at 0.
    const bool from_zero = std::string_view(format.iformat->name).starts_with("matroska");
    const double first = stream.start_time == AV_NOPTS_VALUE ? 0 : static_cast<double>(stream.start_time) * tick;
    return from_zero && first > 0 && first < stated ? stated - first : stated;
}

std::optional<std::int64_t> creation_time(const AVFormatContext& format) {
    const AVDictionaryEntry* const tag = av_dict_get(format.metadata, "creation_time", nullptr, 0);
    std::int64_t microseconds = 0;
    if (tag == nullptr || av_parse_time(&microseconds, tag->value, 0) < 0) return std::nullopt;
    return microseconds / 1'000'000;
}

}  // namespace

Orientation orientation_of(const AVStream& stream) {
    std::size_t bytes = 0;
    const auto* data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &bytes);
    if (!data || bytes < 9 * sizeof(std::int32_t)) return {};
    const auto* matrix = reinterpret_cast<const std::int32_t*>(data);
    // A pixel (x, y) is shown at (a·x + c·y, b·x + d·y).
    const std::int64_t a = matrix[0], b = matrix[1], c = matrix[3], d = matrix[4];
    if (std::abs(c) > std::abs(a)) return {true, c < 0, b < 0};
    return {false, a < 0, d < 0};
}

VideoInfo describe(const Demuxer& demuxer, const std::string& name, const AVFrame& first,
                   const std::optional<Aspect>& shape) {
    AVFormatContext& format = demuxer.format();
    AVStream& stream = demuxer.stream();
    const std::string formats = format.iformat->name;
    VideoInfo info;
    info.name = name;
    info.container = formats.substr(0, formats.find(','));
    info.codec = avcodec_get_name(stream.codecpar->codec_id);
    info.size =
        shown_size(first, av_guess_sample_aspect_ratio(&format, &stream, nullptr), orientation_of(stream), shape);
    const ClipHeader header = header_of(demuxer);
    info.rate = header.rate;
    info.duration = header.length;
    info.frames = header.frames;
    info.created = header.created;
    return info;
}

ClipHeader header_of(const Demuxer& demuxer) {
    const AVStream& stream = demuxer.stream();
    ClipHeader header;
    header.picture = {stream.codecpar->width, stream.codecpar->height};
    header.rate = stream.avg_frame_rate.den > 0 ? av_q2d(stream.avg_frame_rate) / demuxer.stretch() : 0;
    if (demuxer.lacking() > 0) header.rate = 1 / demuxer.frame_duration();
    header.length = stated_duration(demuxer.format(), stream) * demuxer.stretch() + demuxer.lacking();
    if (header.length > longest_clip) header.implausible_length = std::exchange(header.length, 0);
    header.frames = stream.nb_frames;
    header.created = creation_time(demuxer.format());
    if (header.frames <= 0) header.frames = std::llround(header.length * header.rate);
    return header;
}

double share_of_sound(const Demuxer& demuxer) {
    constexpr double together = 3;  // seconds
    const AVFormatContext& format = demuxer.format();
    const auto begin_of = [](const AVStream& stream) {
        return stream.start_time == AV_NOPTS_VALUE ? 0
                                                   : static_cast<double>(stream.start_time) * av_q2d(stream.time_base);
    };
    const double length = header_of(demuxer).length;
    double sound = 0;
    for (unsigned i = 0; i < format.nb_streams; ++i) {
        const AVStream& stream = *format.streams[i];
        if (stream.codecpar->codec_type != AVMEDIA_TYPE_AUDIO || stream.duration <= 0) continue;
        const double end = begin_of(stream) + static_cast<double>(stream.duration) * av_q2d(stream.time_base);
        sound = std::max(sound, end - begin_of(demuxer.stream()));
    }
    return length <= 0 || sound <= 0 || std::abs(sound - length) < together ? 1 : sound / length;
}

namespace {

constexpr std::array table{
    ContainerRow{".mp4", "mp4", {AV_CODEC_ID_H264, AV_CODEC_ID_HEVC, AV_CODEC_ID_AV1}},
    ContainerRow{".mov", "mov"},
    ContainerRow{".m4v", "mp4"},
    ContainerRow{".mkv", "matroska"},
    ContainerRow{".webm", "webm", {AV_CODEC_ID_VP8, AV_CODEC_ID_VP9}},
    ContainerRow{".avi", "avi"},
};

bool holds(const char* muxer, AVCodecID codec) {
    const AVOutputFormat* const format = av_guess_format(muxer, nullptr, nullptr);
    // Matroska can hold AVI codecs by their AVI tags. libav calls that unofficial, but every player supports it.
    return format != nullptr && avformat_query_codec(format, codec, FF_COMPLIANCE_UNOFFICIAL) == 1;
}

bool holds_all(const ContainerRow& row, const AVFormatContext& clip) {
    return std::ranges::all_of(media_of(clip),
                               [&](const AVStream* stream) { return holds(row.muxer, stream->codecpar->codec_id); });
}

bool is_media(const AVStream& stream) {
    const AVMediaType type = stream.codecpar->codec_type;
    return (type == AVMEDIA_TYPE_VIDEO || type == AVMEDIA_TYPE_AUDIO || type == AVMEDIA_TYPE_SUBTITLE) &&
           (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) == 0;
}

}  // namespace

std::span<const ContainerRow> containers() {
    return table;
}

const ContainerRow& container_of(const std::filesystem::path& path) {
    const auto row = std::ranges::find(table, extension_of(path), &ContainerRow::name);
    if (row != table.end()) return *row;
    throw Error(ErrorCode::output_format_unknown,
                fmt::format("cannot write '{}': unknown container; use a file name that ends in {}", path.string(),
                            fmt::join(names_of(table), ", ")));
}

std::vector<const AVStream*> media_of(const AVFormatContext& clip) {
    std::vector<const AVStream*> streams;
    for (unsigned i = 0; i < clip.nb_streams; ++i) {
        if (is_media(*clip.streams[i])) streams.push_back(clip.streams[i]);
    }
    return streams;
}

void check_container(const ContainerRow& container, const AVFormatContext& clip, const std::filesystem::path& path) {
    if (holds_all(container, clip)) return;
    const std::vector<const AVStream*> streams = media_of(clip);
    const auto refused = std::ranges::find_if(
        streams, [&](const AVStream* s) { return !holds(container.muxer, s->codecpar->codec_id); });
    std::vector<std::string_view> others;
    for (const ContainerRow& row : table) {
        if (holds_all(row, clip)) others.push_back(row.name);
    }
    throw Error(
        ErrorCode::options_conflict,
        fmt::format("cannot write '{}': {} can't hold {}; {}", path.string(), container.name, name_of(**refused),
                    others.empty() ? std::string(encode_with_ffmpeg) : fmt::format("use {}", fmt::join(others, ", "))));
}

std::string_view extension_for(const Input& clip, double rate) {
    const Demuxer demuxer(clip, Demuxer::Kind::video, rate);
    const auto own = std::ranges::find(table, extension_of(clip.name), &ContainerRow::name);
    if (own != table.end() && holds_all(*own, demuxer.format())) return own->name;
    const auto row = std::ranges::find_if(table, [&](const auto& each) { return holds_all(each, demuxer.format()); });
    return row == table.end() ? std::string_view() : row->name;
}

std::string_view extension_to_play(const Input& clip, double rate) {
    const Demuxer demuxer(clip, Demuxer::Kind::video, rate);
    const AVCodecID codec = demuxer.stream().codecpar->codec_id;
    const auto row = std::ranges::find_if(table, [&](const ContainerRow& each) {
        return std::ranges::count(each.played, codec) > 0 && holds_all(each, demuxer.format());
    });
    return row == table.end() ? extension_for(clip, rate) : row->name;
}

}  // namespace vvr::media
