#include "core/video/packet_copy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

extern "C" {
#include <libavutil/parseutils.h>
}

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/choice.h"
#include "core/ending.h"
#include "core/error.h"
#include "core/video/demuxer.h"

namespace vvr {
namespace {

constexpr std::array table{
    ContainerRow{".mp4", "mp4"},      ContainerRow{".mov", "mov"},   ContainerRow{".m4v", "mp4"},
    ContainerRow{".mkv", "matroska"}, ContainerRow{".webm", "webm"}, ContainerRow{".avi", "avi"},
};

/// Sound lies beside its pictures, but some recorders write it seconds later.
constexpr double interleaving = 10;  // seconds

struct FreeMuxer {
    void operator()(AVFormatContext* context) const { avformat_free_context(context); }
};

bool holds(const char* muxer, AVCodecID codec) {
    const AVOutputFormat* const format = av_guess_format(muxer, nullptr, nullptr);
    // Matroska holds what AVI does by AVI's own names; libav calls that unofficial, and every player reads it.
    return format != nullptr && avformat_query_codec(format, codec, FF_COMPLIANCE_UNOFFICIAL) == 1;
}

bool is_media(const AVStream& stream) {
    const AVMediaType type = stream.codecpar->codec_type;
    return (type == AVMEDIA_TYPE_VIDEO || type == AVMEDIA_TYPE_AUDIO || type == AVMEDIA_TYPE_SUBTITLE) &&
           (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) == 0;
}

std::string name_of(const AVStream& stream) {
    const char* const kind = av_get_media_type_string(stream.codecpar->codec_type);
    const bool cover = (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) != 0;
    return fmt::format("{} ({})",
                       cover  ? "cover picture"
                       : kind ? kind
                              : "data",
                       avcodec_get_name(stream.codecpar->codec_id));
}

std::vector<const AVStream*> media_of(const AVFormatContext& format) {
    std::vector<const AVStream*> streams;
    for (unsigned i = 0; i < format.nb_streams; ++i) {
        if (is_media(*format.streams[i])) streams.push_back(format.streams[i]);
    }
    return streams;
}

void check_container(const ContainerRow& container, const AVFormatContext& format, const std::filesystem::path& path) {
    const std::vector<const AVStream*> streams = media_of(format);
    const auto holds_all = [&](const ContainerRow& row) {
        return std::ranges::all_of(streams, [&](const AVStream* s) { return holds(row.muxer, s->codecpar->codec_id); });
    };
    if (holds_all(container)) return;
    const auto refused = std::ranges::find_if(
        streams, [&](const AVStream* s) { return !holds(container.muxer, s->codecpar->codec_id); });
    std::vector<std::string> others;
    for (const ContainerRow& row : table) {
        if (holds_all(row)) others.emplace_back(row.name);
    }
    throw Error(ErrorKind::usage,
                fmt::format("cannot write '{}': {} can't hold {}; {}cut it exactly, which encodes the video anew",
                            path.string(), container.name, name_of(**refused),
                            others.empty() ? "" : fmt::format("choose {}, or ", fmt::join(others, ", "))),
                {"exact"});
}

/// The tag by which a container names the codec, where the new container knows it too.
std::uint32_t tag_for(const AVOutputFormat& format, const AVCodecParameters& codec) {
    if (format.codec_tag == nullptr) return codec.codec_tag;
    const bool known = av_codec_get_id(format.codec_tag, codec.codec_tag) == codec.codec_id;
    return known ? codec.codec_tag : 0;
}

void copy_tag(AVDictionary*& to, const AVDictionary* from, const char* key) {
    const AVDictionaryEntry* const entry = av_dict_get(from, key, nullptr, 0);
    if (entry != nullptr) av_dict_set(&to, key, entry->value, 0);
}

/// Writes packets to a container.
class Muxer {
  public:
    Muxer(const AVFormatContext& from, const ContainerRow& container, const std::filesystem::path& path,
          const WriteAt& write_at)
        : path_(path), writer_(write_at), streams_(from.nb_streams, nullptr) {
        AVFormatContext* made = nullptr;
        check(avformat_alloc_output_context2(&made, nullptr, container.muxer, nullptr));
        format_.reset(made);
        log_.attach(*format_);
        format_->pb = writer_.context();
        format_->flags |= AVFMT_FLAG_BITEXACT;  // no version, no random number
        for (unsigned i = 0; i < from.nb_streams; ++i) {
            if (is_media(*from.streams[i])) streams_[i] = add(*from.streams[i]);
        }
    }

    /// Muxers free their last packet only with the trailer, so it is written even if the file is not wanted.
    ~Muxer() {
        if (begun_) av_write_trailer(format_.get());
    }
    Muxer(const Muxer&) = delete;
    Muxer& operator=(const Muxer&) = delete;

    /// \param seconds from the beginning of the clip to that of the piece
    void begin(const AVFormatContext& from, double seconds) {
        const AVDictionaryEntry* const tag = av_dict_get(from.metadata, "creation_time", nullptr, 0);
        std::int64_t microseconds = 0;
        if (tag != nullptr && av_parse_time(&microseconds, tag->value, 0) >= 0) {
            set_recorded(microseconds + std::llround(seconds * 1e6));
        }
        const int code = avformat_write_header(format_.get(), nullptr);
        if (code < 0) fail("begin", code);
        begun_ = true;
    }

    /// Whether there is a place for the packets of one of the input's streams; some show up in the middle of a file.
    bool takes(int stream) const {
        return std::cmp_less(stream, streams_.size()) && streams_[static_cast<std::size_t>(stream)] != nullptr;
    }

    /// \param from the stream that the packet is of
    /// \param zero time of the piece's beginning, in ticks of that stream
    void add(AVPacket& packet, const AVStream& from, std::int64_t zero) {
        AVStream& to = *streams_[static_cast<std::size_t>(packet.stream_index)];
        std::int64_t& last = last_dts_[static_cast<std::size_t>(to.index)];
        if (packet.pts == AV_NOPTS_VALUE) packet.pts = packet.dts;
        if (packet.dts == AV_NOPTS_VALUE && from.codecpar->video_delay == 0) packet.dts = packet.pts;
        packet.pts -= zero;
        if (packet.dts != AV_NOPTS_VALUE) packet.dts -= zero;
        av_packet_rescale_ts(&packet, from.time_base, to.time_base);
        // Times that stand still or step back come of damage, or of a coarser clock; containers want them to go on.
        if (packet.dts != AV_NOPTS_VALUE) {
            packet.dts = std::max(packet.dts, last + 1);
            packet.pts = std::max(packet.pts, packet.dts);
            last = packet.dts;
        }
        packet.stream_index = to.index;
        packet.pos = -1;
        const int code = av_interleaved_write_frame(format_.get(), &packet);
        if (code < 0) fail("write", code);
    }

    void close() {
        begun_ = false;
        const int code = av_write_trailer(format_.get());
        if (code < 0) fail("end", code);
        writer_.flush();
    }

  private:
    void check(int code) const {
        if (code < 0) fail("begin", code);
    }

    [[noreturn]] void fail(const char* what, int code) const {
        writer_.check();
        throw Error(ErrorKind::io, fmt::format("cannot {} '{}': {}; try another container, such as .mkv", what,
                                               path_.string(), log_.text(code)));
    }

    AVStream* add(const AVStream& from) {
        AVStream* const to = avformat_new_stream(format_.get(), nullptr);
        if (to == nullptr || avcodec_parameters_copy(to->codecpar, from.codecpar) < 0) {
            throw Error(ErrorKind::limit, "out of memory for copying a video");
        }
        to->codecpar->codec_tag = tag_for(*format_->oformat, *from.codecpar);
        to->time_base = from.time_base;
        // AVI has a place for every tick, and fills each that has no frame.
        const bool counts_frames = from.codecpar->codec_type == AVMEDIA_TYPE_VIDEO && from.r_frame_rate.num > 0;
        if (std::string_view(format_->oformat->name) == "avi" && counts_frames) {
            to->time_base = av_inv_q(from.r_frame_rate);
        }
        to->avg_frame_rate = from.avg_frame_rate;
        to->sample_aspect_ratio = from.sample_aspect_ratio;
        to->disposition = from.disposition;
        copy_tag(to->metadata, from.metadata, "language");
        std::size_t size = 0;
        if (const auto* turned = av_stream_get_side_data(&from, AV_PKT_DATA_DISPLAYMATRIX, &size)) {
            std::uint8_t* const copy = av_stream_new_side_data(to, AV_PKT_DATA_DISPLAYMATRIX, size);
            if (copy != nullptr) std::copy_n(turned, size, copy);
        }
        last_dts_.push_back(std::numeric_limits<std::int64_t>::min() / 2);
        return to;
    }

    void set_recorded(std::int64_t microseconds) {
        const std::time_t seconds = microseconds / 1'000'000;
        std::tm time{};
        gmtime_r(&seconds, &time);
        std::array<char, 32> text{};
        std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &time);
        av_dict_set(&format_->metadata, "creation_time", text.data(), 0);
    }

    const std::filesystem::path& path_;
    AvWriter writer_;
    av::Log log_;
    std::unique_ptr<AVFormatContext, FreeMuxer> format_;
    std::vector<AVStream*> streams_;        ///< of each stream of the input; none = it is left out
    std::vector<std::int64_t> last_dts_{};  ///< of each stream of the output
    bool begun_ = false;
};

}  // namespace

std::span<const ContainerRow> containers() {
    return table;
}

const ContainerRow& container_of(const std::filesystem::path& path) {
    const auto row = std::ranges::find(table, ending_of(path), &ContainerRow::name);
    if (row != table.end()) return *row;
    throw Error(ErrorKind::usage, fmt::format("cannot write '{}': the name of a clip ends in {}", path.string(),
                                              fmt::join(names_of(table), ", ")));
}

Copied copy_piece(const Input& input, double rate, const Piece& piece, const std::filesystem::path& path,
                  const WriteAt& write_at, const std::function<bool()>& stopped) {
    const ContainerRow& container = container_of(path);
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    demuxer.take_all_streams();
    const AVFormatContext& from = demuxer.format();
    check_container(container, from, path);
    Copied copied;
    for (unsigned i = 0; i < from.nb_streams; ++i) {
        if (!is_media(*from.streams[i])) copied.left_out.push_back(name_of(*from.streams[i]));
    }
    Muxer muxer(from, container, path, write_at);
    muxer.begin(from, piece.begin);

    const AVStream& video = demuxer.stream();
    const auto stamp_of = [](const AVPacket& p) { return p.pts != AV_NOPTS_VALUE ? p.pts : p.dts; };
    const auto packet = av::make_packet();
    std::int64_t number = -1;  // of the last packet of the video
    while (!copied.stopped && demuxer.read_any(*packet)) {
        copied.stopped = stopped();
        const AVStream& stream = *from.streams[packet->stream_index];
        const std::int64_t stamp = stamp_of(*packet);
        if (&stream == &video) {
            ++number;
            if (number > piece.last && *demuxer.seconds(stamp) > *demuxer.seconds(piece.last_stamp) + interleaving)
                break;
            if (number < piece.first || number > piece.last || stamp < piece.first_stamp) continue;
            ++copied.packets;
        } else if (!muxer.takes(packet->stream_index) || stamp == AV_NOPTS_VALUE ||
                   av_compare_ts(stamp, stream.time_base, piece.first_stamp, video.time_base) < 0 ||
                   av_compare_ts(stamp, stream.time_base, piece.last_stamp, video.time_base) > 0) {
            continue;
        }
        muxer.add(*packet, stream, av_rescale_q(piece.first_stamp, video.time_base, stream.time_base));
    }
    muxer.close();
    return copied;
}

}  // namespace vvr
