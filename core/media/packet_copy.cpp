#include "core/media/packet_copy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/media/container.h"
#include "core/media/demuxer.h"

namespace vvr::media {
namespace {

/// Audio is interleaved with video, but some recorders write it seconds later.
constexpr double interleaving = 10;  // seconds

/// The codec tag for the new container: the old tag if the container supports it or has no tag for the codec, else 0.
std::uint32_t tag_for(const AVOutputFormat& format, const AVCodecParameters& codec) {
    if (format.codec_tag == nullptr) return codec.codec_tag;
    unsigned int other = 0;
    const bool fits = av_codec_get_id(format.codec_tag, codec.codec_tag) == codec.codec_id ||
                      av_codec_get_tag2(format.codec_tag, codec.codec_id, &other) == 0;
    return fits ? codec.codec_tag : 0;
}

/// Whether packets of two streams can be joined in one stream.
bool are_compatible(const AVCodecParameters& a, const AVCodecParameters& b) {
    return a.codec_id == b.codec_id && a.width == b.width && a.height == b.height && a.sample_rate == b.sample_rate &&
           a.ch_layout.nb_channels == b.ch_layout.nb_channels && a.extradata_size == b.extradata_size &&
           (a.extradata_size == 0 ||
            std::memcmp(a.extradata, b.extradata, static_cast<std::size_t>(a.extradata_size)) == 0);
}

/// A codec for messages: "h264 640x480".
std::string text_of(const AVCodecParameters& codec) {
    std::string name = avcodec_get_name(codec.codec_id);
    if (codec.codec_type == AVMEDIA_TYPE_VIDEO) return fmt::format("{} {}x{}", name, codec.width, codec.height);
    if (codec.codec_type == AVMEDIA_TYPE_AUDIO) return fmt::format("{} {} Hz", name, codec.sample_rate);
    return name;
}

void copy_tag(AVDictionary*& to, const AVDictionary* from, const char* key) {
    const AVDictionaryEntry* const entry = av_dict_get(from, key, nullptr, 0);
    if (entry != nullptr) av_dict_set(&to, key, entry->value, 0);
}

/// Writes packets of several files to a container.
class Joiner {
  public:
    Joiner(const AVFormatContext& from, const ContainerRow& container, const std::filesystem::path& path,
           const WriteAt& write_at)
        : muxer_(container.muxer, write_at, [&, this](const char* what, int code) {
              const bool is_mkv = container.name == ".mkv";
              throw Error(ErrorCode::io,
                          fmt::format("cannot {} '{}': {}; {}", what, path.string(), log_.text(code),
                                      is_mkv ? encode_with_ffmpeg : "try another container, such as .mkv"));
          }) {
        log_.attach(muxer_.format());
        for (const AVStream* stream : media_of(from)) streams_.push_back({add(*stream)});
    }

    void begin(const Tags& tags) {
        for (const auto& [key, value] : tags) av_dict_set(&muxer_.format().metadata, key.c_str(), value.c_str(), 0);
        muxer_.check("write the header of", muxer_.begin());
    }

    /// Continues with the packets of another file.
    /// \param name name of the file, for messages
    /// \throws Error usage if its streams differ from those of the first file
    void begin_file(const AVFormatContext& from, const std::string& name) {
        const std::vector<const AVStream*> media = media_of(from);
        place_of_.assign(from.nb_streams, none);
        for (std::size_t i = 0; i < std::max(media.size(), streams_.size()); ++i) {
            const AVCodecParameters* const is = i < media.size() ? media[i]->codecpar : nullptr;
            const AVCodecParameters* const was = i < streams_.size() ? streams_[i].to->codecpar : nullptr;
            if (!is || !was || !are_compatible(*is, *was)) refuse(name, was, is);
            place_of_[static_cast<std::size_t>(media[i]->index)] = i;
            streams_[i].begins = true;
        }
    }

    /// Whether a stream of the file is copied. Streams that begin in the middle of a file are not.
    bool copies(int stream) const {
        return std::cmp_less(stream, place_of_.size()) && place_of_[static_cast<std::size_t>(stream)] != none;
    }

    /// \param from the packet's stream
    /// \param zero start of the copy, in that stream's time base
    /// \param joined whether other files precede, whose audio may overlap this file
    void add(AVPacket& packet, const AVStream& from, std::int64_t zero, bool joined) {
        Place& place = streams_[place_of_[static_cast<std::size_t>(packet.stream_index)]];
        if (packet.pts == AV_NOPTS_VALUE) packet.pts = packet.dts;
        if (packet.dts == AV_NOPTS_VALUE && from.codecpar->video_delay == 0) packet.dts = packet.pts;
        packet.pts -= zero;
        if (packet.dts != AV_NOPTS_VALUE) packet.dts -= zero;
        av_packet_rescale_ts(&packet, from.time_base, place.to->time_base);
        const bool is_video = from.codecpar->codec_type == AVMEDIA_TYPE_VIDEO;
        const bool begins = std::exchange(place.begins, false);
        if (joined && packet.dts == AV_NOPTS_VALUE && from.codecpar->video_delay > 0) {
            // Matroska leaves out the DTS of a file's first packets. Muxers make it up at their own beginning only.
            const std::int64_t lead = from.codecpar->video_delay * std::max<std::int64_t>(1, packet.duration);
            packet.dts = begins ? packet.pts - lead : place.last_dts + 1;
        }
        if (joined && !is_video && packet.dts != AV_NOPTS_VALUE && packet.dts <= place.last_dts) return;
        // Damage or a coarser time base may repeat timestamps or step back, but containers need increasing ones.
        if (packet.dts != AV_NOPTS_VALUE) {
            packet.dts = std::max(packet.dts, place.last_dts + 1);
            packet.pts = std::max(packet.pts, packet.dts);
            place.last_dts = packet.dts;
        }
        packet.stream_index = place.to->index;
        packet.pos = -1;
        muxer_.add(packet);
    }

    void close() { muxer_.close(); }

  private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    struct Place {
        AVStream* to = nullptr;
        std::int64_t last_dts = std::numeric_limits<std::int64_t>::min() / 2;
        bool begins = true;  ///< no packet of the current file yet
    };

    [[noreturn]] static void refuse(const std::string& name, const AVCodecParameters* was,
                                    const AVCodecParameters* is) {
        const auto text = [](const AVCodecParameters* codec) { return codec ? text_of(*codec) : "nothing"; };
        const bool settings = was && is && text(was) == text(is);
        throw Error(
            ErrorCode::input_unsuitable,
            fmt::format(
                "cannot join '{}' to the previous file without re-encoding: it has {}, the previous one has {}{}; "
                "cut each file by itself",
                name, text(is), text(was), settings ? " with other settings" : ""));
    }

    AVStream* add(const AVStream& from) {
        AVFormatContext& format = muxer_.format();
        AVStream* const to = avformat_new_stream(&format, nullptr);
        if (to == nullptr || avcodec_parameters_copy(to->codecpar, from.codecpar) < 0) {
            throw Error(ErrorCode::out_of_memory, "out of memory for copying a video; give vvr more memory");
        }
        to->codecpar->codec_tag = tag_for(*format.oformat, *from.codecpar);
        to->time_base = from.time_base;
        // AVI stores an entry for every tick of the time base, so a tick must be a frame.
        const bool counts_frames = from.codecpar->codec_type == AVMEDIA_TYPE_VIDEO && from.r_frame_rate.num > 0;
        if (std::string_view(format.oformat->name) == "avi" && counts_frames) {
            to->time_base = av_inv_q(from.r_frame_rate);
        }
        to->avg_frame_rate = from.avg_frame_rate;
        const bool has_aspect = from.sample_aspect_ratio.num > 0;
        to->sample_aspect_ratio = has_aspect ? from.sample_aspect_ratio : from.codecpar->sample_aspect_ratio;
        to->codecpar->sample_aspect_ratio = to->sample_aspect_ratio;
        to->disposition = from.disposition;
        copy_tag(to->metadata, from.metadata, "language");
        std::size_t size = 0;
        if (const auto* turned = av_stream_get_side_data(&from, AV_PKT_DATA_DISPLAYMATRIX, &size)) {
            std::uint8_t* const copy = av_stream_new_side_data(to, AV_PKT_DATA_DISPLAYMATRIX, size);
            if (copy != nullptr) std::copy_n(turned, size, copy);
        }
        return to;
    }

    av::Log log_;
    AvMuxer muxer_;
    std::vector<Place> streams_;           ///< in the order of media_of
    std::vector<std::size_t> place_of_{};  ///< by stream index of the current file; none = omitted
};

std::vector<std::string> names_left_out(const AVFormatContext& from) {
    const std::vector<const AVStream*> media = media_of(from);
    std::vector<std::string> names;
    for (unsigned i = 0; i < from.nb_streams; ++i) {
        if (std::ranges::find(media, from.streams[i]) == media.end()) names.push_back(name_of(*from.streams[i]));
    }
    return names;
}

/// Copies the packets of a part.
class PartCopy {
  public:
    /// \param seconds start of the part in the copy
    PartCopy(const CopyPart& part, Demuxer& demuxer, double seconds)
        : piece_(part.piece), demuxer_(demuxer), video_(demuxer.stream()), seconds_(seconds) {}

    void operator()(Joiner& joiner, bool joined, bool is_last, CopyResult& copied,
                    const std::function<void()>& check_stop) {
        const AVFormatContext& from = demuxer_.format();
        const auto packet = av::make_packet();
        std::int64_t number = -1;  // index of the last video packet
        while (demuxer_.read_any(*packet)) {
            check_stop();
            const AVStream& stream = *from.streams[packet->stream_index];
            const std::int64_t stamp = stamp_of(*packet);
            if (&stream == &video_) {
                ++number;
                if (number > piece_.last && is_over(stamp)) break;
                if (number < piece_.first || number > piece_.last || stamp < piece_.first_stamp) continue;
                ++copied.packets;
            } else if (!joiner.copies(packet->stream_index) || !is_in_range(stream, stamp, is_last)) {
                continue;
            }
            joiner.add(*packet, stream, zero_of(stream), joined);
        }
    }

  private:
    bool is_over(std::int64_t stamp) const {
        return demuxer_.seconds(stamp) > *demuxer_.seconds(piece_.last_stamp) + interleaving;
    }

    /// Whether a packet of another stream is within the packet range. A range that ends with the file includes the
    /// rest.
    bool is_in_range(const AVStream& stream, std::int64_t stamp, bool is_last) const {
        const auto is_before = [&](std::int64_t video_stamp) {
            return av_compare_ts(stamp, stream.time_base, video_stamp, video_.time_base) < 0;
        };
        if (stamp == AV_NOPTS_VALUE || is_before(piece_.first_stamp)) return false;
        return !is_last || is_before(piece_.last_stamp + 1);
    }

    std::int64_t zero_of(const AVStream& stream) const {
        const std::int64_t first = av_rescale_q(piece_.first_stamp, video_.time_base, stream.time_base);
        return first - std::llround(seconds_ / av_q2d(stream.time_base));
    }

    const PacketRange& piece_;
    Demuxer& demuxer_;
    const AVStream& video_;
    double seconds_;
};

}  // namespace

CopyResult copy_pieces(std::span<const CopyPart> parts, double rate, const std::filesystem::path& path,
                       const Tags& tags, const WriteAt& write_at, const std::function<void()>& check_stop) {
    const ContainerRow& container = container_of(path);
    const double zero = parts.front().begin + parts.front().piece.begin;
    std::optional<Joiner> joiner;
    CopyResult copied;
    for (const CopyPart& part : parts) {
        Demuxer demuxer(part.input, Demuxer::Kind::video, rate);
        demuxer.select_all_streams();
        const AVFormatContext& from = demuxer.format();
        if (!joiner) {
            check_container(container, from, path);
            copied.left_out = names_left_out(from);
            joiner.emplace(from, container, path, write_at).begin(tags);
        }
        joiner->begin_file(from, part.input.name);
        const bool is_last = &part == &parts.back();
        PartCopy(part, demuxer, part.begin + part.piece.begin - zero)(*joiner, &part != &parts.front(), is_last, copied,
                                                                      check_stop);
    }
    joiner->close();
    return copied;
}

}  // namespace vvr::media
