#include "core/media/file_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/media/container.h"
#include "core/media/frame_sampler.h"
#include "core/media/scaler.h"

extern "C" {
#include <libavutil/opt.h>
}

namespace vvr::media {

namespace {

/// The row that `auto` stands for in this clip.
const FrameChoiceRow& resolved(const SourceOptions& options, const VideoInfo& info, Size field) {
    if (!options.decode->automatic) return *options.decode;
    const bool shares = options.layers > 0 && info.frames >= 2 * options.layers;
    return *Choice<FrameChoiceRow>(shares && 2 * field.width <= info.size.width ? "reference" : "all");
}

/// The packets of a clip of which not all frames are decoded.
struct PacketCount {
    double decoded_share = 1;
    double last = -std::numeric_limits<double>::infinity();  ///< timestamp of the last frame, decoded or not, seconds
};

PacketCount count_packets(const FrameChoiceRow& choice, const Input& input, double rate) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    const auto packet = av::make_packet();
    std::int64_t all = 0;
    std::int64_t decoded = 0;
    PacketCount count;
    while (demuxer.read(*packet)) {
        const auto time = demuxer.seconds(stamp_of(*packet));
        count.last = std::max(count.last, time.value_or(count.last));
        ++all;
        decoded += choice.decodes(*packet, *demuxer.stream().codecpar) ? 1 : 0;
    }
    if (decoded > 0) count.decoded_share = static_cast<double>(decoded) / static_cast<double>(all);
    return count;
}

/// Whether the format has no timestamps, so that libav asks for a rate.
bool takes_rate(const AVInputFormat& format) {
    const AVClass* options = format.priv_class;
    return options != nullptr && av_opt_find(&options, "framerate", nullptr, 0, AV_OPT_SEARCH_FAKE_OBJ) != nullptr;
}

}  // namespace

FileSource::FileSource(Input input, const SourceOptions& options)
    : options_(options), reader_(std::move(input), options.rate, options.threads, *options.decode, *options.hwaccel) {
    auto first = reader_.next();
    const auto& name = reader_.input().name;
    if (!first.image) {
        throw Error(
            ErrorCode::no_frame,
            fmt::format("no frame of '{}' ({}) can be decoded: {} damaged packets, {}; run `ffprobe` on it for details",
                        name, avcodec_get_name(reader_.demuxer().stream().codecpar->codec_id), reader_.damaged(),
                        reader_.demuxer().log().text(AVERROR_INVALIDDATA)));
    }
    const Demuxer& demuxer = reader_.demuxer();
    tick_ = demuxer.tick();
    orientation_ = orientation_of(demuxer.stream());
    info_ = describe(demuxer, name, *first.image, options.aspect);
    is_hdr_ = first.image->color_trc == AVCOL_TRC_SMPTE2084 || first.image->color_trc == AVCOL_TRC_ARIB_STD_B67;
    // Without the name, so that a recording says it once.
    if (options.rate == 0 && takes_rate(*demuxer.format().iformat)) {
        notes_.push_back(
            fmt::format("raw video has no timestamps; vvr reads it as {:.6g} frames per second (--rate "
                        "gives another rate)",
                        1 / demuxer.frame_duration()));
    }
    if (options.rate == 0) doubt_times(demuxer);
    if (options.track == 0 && demuxer.tracks() > 1) {
        notes_.push_back(fmt::format("there are {} video tracks; vvr draws track {} (--track chooses another)",
                                     demuxer.tracks(), demuxer.track()));
    }
    info_.read_at = options.rate;
    info_.stretch = demuxer.stretch();
    if (!reader_.fell_back()) info_.hwaccel = options.hwaccel;
    implausible_length_ = header_of(demuxer).implausible_length;
    if (options.begin) {
        info_.began = options.begin;
        info_.began_source = ClockSource::file_name;
    }
    // Without a duration, the modification time doesn't give the start.
    const auto written = info_.duration > 0 ? modified_at(name) : std::nullopt;
    if (written) info_.modified = static_cast<std::int64_t>(*written) - std::llround(info_.duration);
    field_size_ = field_size_for(info_.size, options_.field_size);
    const FrameChoiceRow& choice = resolved(options_, info_, field_size_);
    info_.decodes = choice;
    if (&choice != &*options_.decode) {
        reader_.choose(choice);
        first = reader_.next();
    }
    if (&choice != &frame_choices().front()) {
        const PacketCount count = count_packets(choice, reader_.input(), options_.rate);
        info_.decoded_share = count.decoded_share;
        last_in_file_ = std::max(0.0, count.last - reader_.origin());
        info_.rate *= info_.decoded_share;
        info_.frames = std::llround(static_cast<double>(info_.frames) * info_.decoded_share);
    }
    numbers_ = FrameNumbers(info_.rate);
    ahead_ = std::make_unique<DecodedFrame>(
        DecodedFrame{numbers_(first.time), first.time, orientation_, std::move(first.image)});
}

/// Notes if the times of all frames can hardly be true.
void FileSource::doubt_times(const Demuxer& demuxer) {
    constexpr double near = 1.2;
    constexpr double fastest = 300;  // frames per second of a camera
    const double share = share_of_sound(demuxer);
    if (share > near || share < 1 / near) {
        notes_.push_back(
            fmt::format("the sound is {:.3g} times as long as the video, whose timestamps may be wrong: --rate {:.3g} "
                        "instead of its {:.4g} frames per second makes both as long",
                        share, info_.rate / share, info_.rate));
    } else if (info_.rate > fastest) {
        notes_.push_back(
            fmt::format("the video states {:.4g} frames per second, more than cameras have; if its "
                        "timestamps are wrong, --rate gives the true rate",
                        info_.rate));
    }
}

std::vector<std::string> FileSource::problems() const {
    std::vector<std::string> problems = notes_;
    const auto years = [](double seconds) { return seconds / (365.25 * 86'400); };
    if (implausible_length_ > 0) {
        problems.push_back(fmt::format("'{}' has a duration of {:.0f} years in its header; vvr uses that of its frames",
                                       info_.name, years(implausible_length_)));
    }
    if (const MendedFrames mended = reader_.mended(); mended.frames > 0) {
        problems.push_back(
            fmt::format("'{}': {} from {:.1f} s on have almost the same time: the camera's clock may have gone back. "
                        "vvr shows them at the rate of the others, so times after them may be wrong",
                        info_.name, counted(mended.frames, "frame"), mended.from));
    }
    if (jump_ > 0) {
        problems.push_back(
            fmt::format("'{}': timestamps jump by {:.0f} years between two frames; later times are unreliable",
                        info_.name, years(jump_)));
    }
    if (is_hdr_)
        problems.push_back(
            fmt::format("'{}' is HDR; vvr does not convert its brightness, so stills are dull", info_.name));
    if (unread_ > damaged()) problems.push_back(text_of_unread(info_.name));
    if (reader_.fell_back()) problems.push_back(text_of_fallback(*options_.hwaccel, info_.codec));
    return problems;
}

void FileSource::rewind() {
    jump_ = 0;
    seek(0);
}

void FileSource::seek(double seconds) {
    ahead_.reset();
    // Half-way between two timestamps, so that counting and decoding agree despite rounding.
    from_ = (std::floor(seconds / tick_) - 0.5) * tick_;
    start_ = from_ > 0 ? reader_.find(from_, info_.rate) : SeekPoint{};
    reader_.rewind(start_);
    numbers_ = start_.packets > 0 ? start_.numbers : FrameNumbers(info_.rate);
}

/// Returns the frame.
std::unique_ptr<DecodedFrame> FileSource::record_jump(std::unique_ptr<DecodedFrame> frame) {
    if (!frame) return nullptr;
    if (frame->pts - last_time_ > longest_clip) jump_ = std::max(jump_, frame->pts - last_time_);
    last_time_ = frame->pts;
    return frame;
}

std::unique_ptr<DecodedFrame> FileSource::next() {
    if (ahead_) return record_jump(std::move(ahead_));
    for (;;) {
        auto [image, time] = reader_.next();
        if (!image) {
            reader_.close();
            return nullptr;
        }
        if (start_.packets == 0 || time >= from_) {
            return record_jump(
                std::make_unique<DecodedFrame>(DecodedFrame{numbers_(time), time, orientation_, std::move(image)}));
        }
        reader_.forget_damage();
    }
}

std::vector<Frame> FileSource::sample(int count) {
    // Every open reader holds the clip's index, which is 24 MB for six hours.
    ahead_.reset();
    reader_.close();
    KeyFrames keys(count, info_.rate);
    keys.scan(reader_.input(), options_.rate, 0);
    unread_ = keys.unread();
    Scaler scale(*this);
    auto frames = keys.decode(options_.rate, options_.threads, scale);
    const bool all = info_.decodes == Choice<FrameChoiceRow>(frame_choices().front());
    if (frames.empty() && all) frames = sample_needed(reader_.input(), options_, info_.rate, count, scale);
    if (frames.empty()) {
        frames = sample_all(count);
        unread_ = reader_.damaged();
    }
    rewind();
    return frames;
}

}  // namespace vvr::media
