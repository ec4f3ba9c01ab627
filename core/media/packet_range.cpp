#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/media/container.h"
#include "core/media/demuxer.h"
#include "core/media/packet_copy.h"
#include "core/media/video_reader.h"

namespace vvr::media {
namespace {

constexpr std::size_t reordered = 16;  // packets; no codec reorders more

struct VideoPacket {
    std::int64_t stamp;
    bool key;
    bool damaged;
};

[[noreturn]] void throw_no_times(const Input& input, const std::string& what) {
    throw Error(ErrorCode::copy_impossible,
                fmt::format("cannot copy '{}': {}; {}", input.name, what, encode_with_ffmpeg));
}

/// Presentation time of the first frame on the container's clock, seconds.
double origin_of(const Input& input, double rate) {
    VideoReader reader(input, rate, 1);
    if (!reader.next().image) {
        throw Error(ErrorCode::no_frame,
                    fmt::format("no frame of '{}' can be decoded; run `ffprobe` on it for details", input.name));
    }
    return reader.origin();
}

/// Scans the packets of the video stream in file order, until slightly after the span.
class Scan {
  public:
    Scan(const Input& input, double rate, const FrameSpan& span)
        : input_(input), span_(span), origin_(origin_of(input, rate)), demuxer_(input, Demuxer::Kind::video, rate) {
        const auto packet = av::make_packet();
        while (!is_done() && demuxer_.read(*packet)) add(*packet);
        for (std::size_t k = 0; k < packets_.size(); ++k) {
            if (const double time = seconds(packets_[k].stamp); time >= -time_tolerance)
                shown_.push_back({k, 0, time, packets_[k].damaged});
        }
        std::ranges::stable_sort(shown_, {}, [&](const auto& one) { return packets_[one.packet].stamp; });
        FrameNumbers numbers(rate_);
        for (PacketRange::Frame& one : shown_) one.number = numbers(one.time);
    }

    /// Whether the clip ends before the span does.
    bool ends_early() const {
        if (packets_.empty() || is_done()) return packets_.empty();
        const bool before_stop = span_.stop && frames() < *span_.stop;
        return before_stop || (span_.end && last_time() + demuxer_.frame_duration() + time_tolerance < *span_.end);
    }

    /// Time of the clip's last frame if it comes before the span.
    std::optional<double> end() const {
        const bool before = last_time() < span_.start || frames() <= span_.first;
        return before && !is_done() ? std::optional(last_time()) : std::nullopt;
    }

    const std::vector<VideoPacket>& packets() const { return packets_; }

    /// The frames in presentation order, from the first that decodes on. Their numbers are those of a `FileSource`.
    const std::vector<PacketRange::Frame>& shown() const { return shown_; }

    double seconds(std::int64_t stamp) const { return *demuxer_.seconds(stamp) - origin_; }
    double frame_duration() const { return demuxer_.frame_duration(); }

  private:
    void add(const AVPacket& packet) {
        if (packet.pts == AV_NOPTS_VALUE && (packet.dts == AV_NOPTS_VALUE || demuxer_.stream().codecpar->video_delay)) {
            throw_no_times(input_, "its packets have no presentation timestamps");
        }
        const std::int64_t stamp = stamp_of(packet);
        if (packet.dts != AV_NOPTS_VALUE) {
            const double dts = seconds(packet.dts);
            if (dts < last_dts_ - clock_was_set) {
                throw_no_times(input_, fmt::format("its timestamps go back by {:.1f} s after {:.1f} s", last_dts_ - dts,
                                                   last_dts_));
            }
            last_dts_ = std::max(last_dts_, dts);
            if (span_.end && dts > *span_.end) ++past_end_;
        }
        packets_.push_back({stamp, (packet.flags & AV_PKT_FLAG_KEY) != 0, (packet.flags & AV_PKT_FLAG_CORRUPT) != 0});
    }

    std::int64_t frames() const { return shown_.empty() ? 0 : shown_.back().number + 1; }

    double last_time() const {
        return packets_.empty() ? 0 : seconds(std::ranges::max(packets_, {}, &VideoPacket::stamp).stamp);
    }

    /// Whether all remaining frames come after the span.
    bool is_done() const {
        const bool past_stop = span_.stop && packets_.size() > static_cast<std::size_t>(*span_.stop) + reordered;
        return past_stop || past_end_ > reordered;
    }

    const Input& input_;
    const FrameSpan& span_;
    double origin_;
    Demuxer demuxer_;
    double rate_ = header_of(demuxer_).rate;
    double last_dts_ = -std::numeric_limits<double>::infinity();
    std::size_t past_end_ = 0;  ///< packets read after the end of the span
    std::vector<VideoPacket> packets_;
    std::vector<PacketRange::Frame> shown_;
};

/// Index of the last packet needed to show the frames up to `last`: packets are reordered, so later ones may be shown
/// earlier.
std::size_t last_needed(const std::vector<VideoPacket>& packets, std::size_t first, std::size_t last) {
    std::int64_t latest = std::numeric_limits<std::int64_t>::min();
    for (std::size_t k = first; k <= last; ++k) latest = std::max(latest, packets[k].stamp);
    const std::size_t end = std::min(packets.size(), last + reordered);
    for (std::size_t k = last + 1; k < end && !packets[k].key; ++k) {
        if (packets[k].stamp < latest) last = k;
    }
    return last;
}

}  // namespace

PacketRange find_packets(const Input& input, double rate, const FrameSpan& span) {
    const Scan scan(input, rate, span);
    const std::vector<VideoPacket>& packets = scan.packets();
    std::vector<std::size_t> inside;  // packets whose frames are in the span, in presentation order
    for (const PacketRange::Frame& frame : scan.shown()) {
        if (!is_before(span, frame.number, frame.time) && !is_past(span, frame.number, frame.time))
            inside.push_back(frame.packet);
    }
    PacketRange range;
    if (inside.empty()) {
        range.over = scan.end();
        return range;
    }
    const std::size_t earliest = std::ranges::min(inside);
    const std::int64_t wanted = packets[inside.front()].stamp;
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k <= earliest; ++k) {
        if (packets[k].key && packets[k].stamp <= wanted) first = k;
    }
    if (!first) throw_no_times(input, "it has no key frame before the requested part");
    const std::size_t last = last_needed(packets, *first, std::ranges::max(inside));

    range.first = static_cast<std::int64_t>(*first);
    range.last = static_cast<std::int64_t>(last);
    range.first_stamp = range.last_stamp = packets[*first].stamp;
    for (std::size_t k = *first; k <= last; ++k) range.last_stamp = std::max(range.last_stamp, packets[k].stamp);
    std::ranges::copy_if(scan.shown(), std::back_inserter(range.frames), [&](const PacketRange::Frame& frame) {
        return frame.packet >= *first && frame.packet <= last && packets[frame.packet].stamp >= range.first_stamp;
    });
    range.begin = scan.seconds(range.first_stamp);
    range.end = scan.seconds(range.last_stamp);
    range.until = range.end + scan.frame_duration();
    range.wanted = scan.seconds(wanted);
    range.ends_early = scan.ends_early();
    return range;
}

double length_of(const Input& input, double rate) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    StampClock clock(demuxer.frame_duration(), origin_of(input, rate));
    double last = 0;
    double last_dts = -std::numeric_limits<double>::infinity();
    std::vector<double> stamps;  // since the last clock jump
    const auto count = [&] {
        std::ranges::sort(stamps);
        for (const double stamp : stamps) last = clock(stamp);
        stamps.clear();
    };
    const auto packet = av::make_packet();
    while (demuxer.read(*packet)) {
        const auto dts = demuxer.seconds(packet->dts);
        const auto stamp = packet->pts == AV_NOPTS_VALUE ? dts : demuxer.seconds(packet->pts);
        if (!stamp || (dts && *dts < last_dts - clock_was_set)) count();
        if (dts) last_dts = *dts;
        if (stamp) {
            stamps.push_back(*stamp);
        } else {
            last = clock(std::nullopt);
        }
    }
    count();
    return last + demuxer.frame_duration();
}

}  // namespace vvr::media
