#include "core/media/stamp_mender.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace vvr::media {

bool StampMender::read(AVPacket& packet, const Read& next) {
    if (ahead_.empty()) {
        if (!next(packet)) return false;
    } else {
        av_packet_unref(&packet);
        av_packet_move_ref(&packet, ahead_.front().get());
        ahead_.pop_front();
        no_run_ -= no_run_ > 0 ? 1 : 0;
    }
    if (is_timed(packet)) mend(packet, next);
    return true;
}

bool StampMender::is_timed(const AVPacket& packet) const {
    return packet.stream_index == stream_ && packet.dts != AV_NOPTS_VALUE && packet.pts != AV_NOPTS_VALUE;
}

bool StampMender::are_tick_apart(const Stamps& before, const Stamps& now) const {
    // If only decoding timestamps are wrong, nothing needs mending.
    const auto shown = static_cast<double>(std::llabs(now.pts - before.pts));
    return is_tick(static_cast<double>(now.dts - before.dts) * tick_, usual_ * tick_) && shown < usual_ / 2;
}

/// Whether many frames from here on are a tick apart. Reads as far as it takes to know.
bool StampMender::begins_run(Stamps before, const Read& next) {
    constexpr std::size_t most = 1000;  // packets, with those of other streams
    int ticks = 0;
    for (std::size_t k = 0; k < most; ++k) {
        if (k == ahead_.size()) {
            auto packet = av::make_packet();
            if (!next(*packet)) break;
            ahead_.push_back(std::move(packet));
        }
        if (!is_timed(*ahead_[k])) continue;
        const Stamps now{ahead_[k]->dts, ahead_[k]->pts};
        if (!are_tick_apart(std::exchange(before, now), now)) break;
        if (++ticks == lasting_ticks) return true;
    }
    no_run_ = ahead_.size();
    return false;
}

void StampMender::mend(AVPacket& packet, const Read& next) {
    constexpr double wide = 2.5;      // usual distances
    constexpr double inertia = 0.1;   // of the usual distance
    constexpr double reordered = 16;  // frames; no codec reorders more
    const Stamps now{packet.dts, packet.pts};
    const Stamps before = std::exchange(last_, now).value_or(now);
    const auto step = static_cast<double>(now.dts - before.dts);
    const bool tick = are_tick_apart(before, now);
    const double gap = std::max(0.0, step - usual_);
    if (!in_run_ && no_run_ == 0 && (tick || step > wide * usual_) && begins_run(now, next)) {
        in_run_ = true;
        if (!tick) offset_ -= gap;
    } else if (in_run_ && !tick) {
        in_run_ = false;
        offset_ = std::max(0.0, offset_ - gap);
    }
    double delay = static_cast<double>(now.pts - now.dts);
    if (in_run_ && tick) {
        offset_ += usual_ - step;
        const double shown = static_cast<double>(now.dts) + offset_;
        if (++mended_.frames == 1) mended_.from = shown * tick_;
        lengthen(mended_.intervals, {(shown - usual_) * tick_, shown * tick_, condition::Kind::times});
        if (delay <= reordered * step) delay *= usual_ / std::max(1.0, step);
    } else if (!in_run_ && step > 0) {
        usual_ += inertia * (std::min(step, 4 * usual_) - usual_);
    }
    if (offset_ == 0) return;
    packet.dts = std::llround(static_cast<double>(now.dts) + offset_);
    packet.pts = packet.dts + std::llround(delay);
}

}  // namespace vvr::media
