#include "core/video/packet_scan.h"

#include <limits>

#include "core/error.h"
#include "core/video/time_sampler.h"

namespace vvr {
namespace {

std::optional<double> presentation(const Demuxer& demuxer, const AVPacket& packet) {
    return demuxer.seconds(packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts);
}

}  // namespace

Start find_start(Demuxer& demuxer, double time) {
    const auto packet = av::make_packet();
    std::int64_t packets = 0;
    std::int64_t frames = 0;
    // Decoding begins a key frame earlier than it need: frames that follow a key frame and are shown before it, and
    // streams that heal over some frames, come out whole then.
    std::int64_t last_key = 0;
    std::int64_t key_before = 0;
    double last_dts = -std::numeric_limits<double>::infinity();
    while (demuxer.read(*packet)) {
        const auto pts = presentation(demuxer, *packet);
        const auto dts = demuxer.seconds(packet->dts);
        // Without times in order the count of frames would be a guess.
        if (!pts || !dts || *dts < last_dts) return {};
        if (*dts >= time) break;
        last_dts = *dts;
        if (*pts < time) ++frames;
        if (packet->flags & AV_PKT_FLAG_KEY && *pts <= time) {
            key_before = last_key;
            last_key = packets;
        }
        ++packets;
    }
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

}  // namespace vvr
