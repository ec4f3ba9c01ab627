#include "core/video/packet_scan.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/video/frame_times.h"

namespace vvr::video {
namespace {

std::optional<double> presentation(const Demuxer& demuxer, const AVPacket& packet) {
    return demuxer.seconds(packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts);
}

/// Whether the codec has frames that need others.
bool leans_on_others(const Demuxer& demuxer) {
    const AVCodecDescriptor* const codec = avcodec_descriptor_get(demuxer.stream().codecpar->codec_id);
    return codec == nullptr || (codec->props & AV_CODEC_PROP_INTRA_ONLY) == 0;
}

/// What the packets from one key packet to the next are for.
/// \param next_leans whether a wanted frame that comes after the next key packet is shown before it
void mark_uses(std::span<const StampedPacket> group, const std::vector<std::int64_t>& wanted, bool next_leans,
               std::span<PacketUse> uses) {
    const auto is_wanted = [&](const StampedPacket& packet) {
        return std::ranges::binary_search(wanted, packet.stamp);
    };
    const auto leads = [&](const StampedPacket& packet) { return packet.stamp < group.front().stamp; };
    const bool leans = std::ranges::any_of(group, [&](const StampedPacket& p) { return leads(p) && is_wanted(p); });
    const auto last = next_leans ? group.rbegin() : std::find_if(group.rbegin(), group.rend(), is_wanted);
    const auto needed = static_cast<std::size_t>(group.rend() - last);
    for (std::size_t i = 0; i < needed; ++i) {
        uses[i] = is_wanted(group[i])         ? PacketUse::frame
                  : leads(group[i]) && !leans ? PacketUse::none
                                              : PacketUse::reference;
    }
}

}  // namespace

SeekPoint find_seek_point(Demuxer& demuxer, double time) {
    const auto packet = av::make_packet();
    std::int64_t packets = 0;
    std::int64_t frames = 0;
    // Decoding begins a key frame earlier than it need: frames that follow a key frame and are shown before it, and
    // streams that heal over some frames, come out whole then.
    std::int64_t last_key = 0;
    std::int64_t key_before = 0;
    std::int64_t keys = 0;
    double last_dts = -std::numeric_limits<double>::infinity();
    while (demuxer.read(*packet)) {
        const auto pts = presentation(demuxer, *packet);
        const auto dts = demuxer.seconds(packet->dts);
        // Without times in order the count of frames would be a guess.
        if (!pts || !dts || *dts < last_dts) return {};
        if (*dts >= time) break;
        last_dts = *dts;
        if (*pts < time) ++frames;
        keys += packet->flags & AV_PKT_FLAG_KEY ? 1 : 0;
        if (packet->flags & AV_PKT_FLAG_KEY && *pts <= time) {
            key_before = last_key;
            last_key = packets;
        }
        ++packets;
    }
    // Some files call each packet a key frame, and of these codecs few are.
    if (keys == packets && leans_on_others(demuxer)) return {};
    return {key_before, frames};
}

KeyPackets find_key_packets(Demuxer& demuxer, int count) {
    TimeSampler<av::Ptr<AVPacket>> sampler(count);
    const auto packet = av::make_packet();
    KeyPackets found;
    double last = -std::numeric_limits<double>::infinity();
    while (demuxer.read(*packet)) {
        const auto pts = presentation(demuxer, *packet);
        if (!(packet->flags & AV_PKT_FLAG_KEY) || !pts || *pts < last) continue;
        ++found.seen;
        last = *pts;
        if (!sampler.wants(*pts)) continue;
        av::Ptr<AVPacket> copy(av_packet_clone(packet.get()));
        if (!copy) throw Error(ErrorKind::limit, "out of memory while reading the video");
        sampler.keep(*pts, std::move(copy));
    }
    found.kept = sampler.take();
    return found;
}

ClipPackets scan_packets(Demuxer& demuxer) {
    const auto packet = av::make_packet();
    ClipPackets clip;
    while (demuxer.read(*packet)) {
        const std::int64_t stamp = packet->pts != AV_NOPTS_VALUE ? packet->pts : packet->dts;
        if (stamp == AV_NOPTS_VALUE || packet->flags & AV_PKT_FLAG_CORRUPT) return {};
        clip.packets.push_back({stamp, (packet->flags & AV_PKT_FLAG_KEY) != 0});
        clip.stamps.push_back(stamp);
    }
    std::ranges::sort(clip.stamps);
    if (std::ranges::adjacent_find(clip.stamps) != clip.stamps.end()) return {};
    StampClock clock(demuxer.frame_duration());
    for (const std::int64_t stamp : clip.stamps) clip.times.push_back(clock(demuxer.seconds(stamp)));
    return clip;
}

std::vector<std::int64_t> sampled_stamps(const ClipPackets& clip, int count) {
    TimeSampler<std::int64_t> sampler(count);
    for (std::size_t i = 0; i < clip.stamps.size(); ++i) {
        if (sampler.wants(clip.times[i])) sampler.keep(clip.times[i], clip.stamps[i]);
    }
    return sampler.take();
}

DecodingPlan plan_decoding(const ClipPackets& clip, std::vector<std::int64_t> stamps) {
    const std::vector<StampedPacket>& packets = clip.packets;
    DecodingPlan plan{std::vector(packets.size(), PacketUse::none), std::move(stamps), {}};
    std::size_t end = packets.size();
    bool next_leans = false;
    // From the last group to the first, as each has to know what the next one leans on.
    for (std::size_t begin = packets.size(); begin-- > 0;) {
        if (begin > 0 && !packets[begin].key) continue;
        const auto group = std::span(packets).subspan(begin, end - begin);
        mark_uses(group, plan.stamps, next_leans, std::span(plan.uses).subspan(begin, end - begin));
        next_leans = std::ranges::any_of(group, [&](const StampedPacket& p) {
            return p.stamp < group.front().stamp && std::ranges::binary_search(plan.stamps, p.stamp);
        });
        if (begin > 0 && !next_leans) plan.starts.push_back({begin, packets[begin].stamp});
        end = begin;
    }
    std::ranges::reverse(plan.starts);
    return plan;
}

std::vector<DecodingPlan> cut_plan(const DecodingPlan& plan, int parts) {
    const auto is_used = [](PacketUse use) { return use != PacketUse::none; };
    const auto all = std::ranges::count_if(plan.uses, is_used);
    std::vector<DecodingPlan> cut;
    RandomAccessPoint begin{0, std::numeric_limits<std::int64_t>::min()};
    std::int64_t used = 0;
    const auto end_at = [&](const RandomAccessPoint& end) {
        DecodingPlan part{std::vector(plan.uses.size(), PacketUse::none), {}, {}};
        for (std::size_t i = begin.packet; i < end.packet; ++i) part.uses[i] = plan.uses[i];
        std::ranges::copy_if(plan.stamps, std::back_inserter(part.stamps),
                             [&](std::int64_t stamp) { return begin.stamp <= stamp && stamp < end.stamp; });
        if (!part.stamps.empty()) cut.push_back(std::move(part));
        begin = end;
    };
    std::size_t counted = 0;
    for (const RandomAccessPoint& start : plan.starts) {
        used += std::count_if(plan.uses.begin() + static_cast<std::ptrdiff_t>(counted),
                              plan.uses.begin() + static_cast<std::ptrdiff_t>(start.packet), is_used);
        counted = start.packet;
        if (used * parts >= all * (std::ssize(cut) + 1)) end_at(start);
    }
    end_at({plan.uses.size(), std::numeric_limits<std::int64_t>::max()});
    return cut;
}

}  // namespace vvr::video
