#include "core/media/live_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/media/container.h"
#include "core/media/input.h"
#include "core/media/scaler.h"

namespace vvr::media {
namespace {

constexpr double gap = 1;                    // seconds between two frames that count as a gap
constexpr double first_pause = 0.5;          // seconds before the first attempt to reconnect
constexpr double longest_pause = 30;         // seconds before later attempts, at most
constexpr std::size_t frames_of_a_pipe = 8;  // decoded ahead
constexpr std::size_t arrivals_kept = 512;
constexpr std::int64_t pixels_waiting = 500'000'000;  // limit for all waiting frames together

// Seconds. If a live camera's timestamp advances this much more than the reader's clock, the camera has set its clock.
constexpr double leap = 10;

double seconds_between(LiveSource::Clock::time_point from, LiveSource::Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

// Frames per second of the fastest cameras.
constexpr double fastest = 240;

/// Whether libav makes timestamps up: the format has none.
bool has_no_stamps(const Demuxer& demuxer) {
    const int flags = demuxer.format().iformat->flags;
    return (flags & AVFMT_NOTIMESTAMPS) != 0 || flags == AVFMT_GENERIC_INDEX;  // HTTP MJPEG, or a raw stream
}

/// The stated frame rate is often wrong, so it is checked against the fastest cameras.
double plausible_rate(const Demuxer& demuxer, double stated) {
    const double rate = stated > 0 && stated <= fastest ? stated : 1 / demuxer.frame_duration();
    return rate > 0 && rate <= fastest ? rate : 25;
}

std::int64_t pixels_of(const DecodedFrame& frame) {
    return std::int64_t{frame.image->width} * frame.image->height;
}

/// Whether the stream is a complete file, which has a known size.
bool is_finished(const Demuxer& demuxer) {
    const AVFormatContext& format = demuxer.format();
    return format.pb != nullptr && !is_playlist_format(*format.iformat) && avio_size(format.pb) > 0;
}

}  // namespace

double LiveClock::operator()(std::optional<double> stamp, double arrival) {
    if (!time_) first_arrival_ = arrival;
    const double passed = time_ ? step(stamp, arrival) : 0;
    time_ = time_.value_or(0) + passed;
    stamp_ = stamp;
    // The last frames of a connection come when it is given up, seconds late. So the delay grows no faster than a
    // camera's clock may be slow.
    constexpr double slowest = 0.05;
    delay_ = passed > 0 ? std::min(arrival - *time_, delay_ + slowest * passed) : arrival;
    return *time_;
}

double LiveClock::step(const std::optional<double>& stamp, double arrival) const {
    constexpr double least = 0.001;  // of frames that arrive together
    if (by_arrival_) return std::max(least, arrival - first_arrival_ - *time_);
    const double passed = std::max(duration_, arrival - delay_ - *time_);
    if (!stamp) return duration_;
    // A file may be read faster than real time, so the reader's clock says nothing about a hole in it.
    const double longest = waits_ ? longest_clip : passed + leap;
    if (!stamp_ || *stamp < *stamp_ || *stamp - *stamp_ > longest) return passed;
    return *stamp - *stamp_;
}

LiveSource::LiveSource(const std::string& name, LiveOptions options)
    : options_(std::move(options)),
      watchdog_(std::make_shared<Watchdog>(std::chrono::duration<double>(options_.patience))),
      input_(open_live_input(name, watchdog_)),
      reconnects_(is_url(input_.url) || !input_.format.empty()),
      waits_(!reconnects_) {
    connect();
    if (is_finished(*demuxer_)) {
        reconnects_ = false;
        waits_ = true;
    }
    info_ = describe(*demuxer_, input_.name, *first_.front().image, options_.source.aspect);
    if (!decoder_->fell_back()) info_.hwaccel = options_.source.hwaccel;
    if (decoder_->fell_back()) options_.report(text_of_fallback(*options_.source.hwaccel, info_.codec));
    info_.rate = plausible_rate(*demuxer_, info_.rate);
    info_.frames = 0;
    info_.duration = 0;
    field_size_ = field_size_for(info_.size, options_.source.field_size);
    clock_ = LiveClock(1 / info_.rate, waits_);
    begin_ = first_.front().when;
    if (has_no_stamps(*demuxer_) && (reconnects_ || input_.pipe)) learn_rate();
    reader_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void LiveSource::connect() {
    watchdog_->feed();
    first_.clear();
    decoder_.reset();
    demuxer_.reset();  // first: its socket may be in use, or the camera may serve only one
    demuxer_ = std::make_unique<Demuxer>(input_, Demuxer::Kind::video, options_.source.rate);
    // A single thread returns a frame as soon as its packet arrives. Each further thread would delay it by one frame.
    const HwaccelRow& hwaccel = *options_.source.hwaccel;
    decoder_ = std::make_unique<Decoder>(*demuxer_, input_.name, 1, std::function<bool(const AVPacket&)>(), hwaccel);
    AvFrame first = decoder_->next();
    if (!first && watchdog_->expired()) throw_timeout(input_);
    if (!first) {
        throw Error(
            ErrorCode::no_frame,
            fmt::format("no frame of '{}' can be decoded: {} damaged packets, {}; run `ffplay` on it for details",
                        input_.name, decoder_->damaged(), demuxer_->log().text(AVERROR_EXIT)));
    }
    first_.push_back({std::move(first), Clock::now()});
    orientation_ = orientation_of(demuxer_->stream());
    clock_.restart();
}

/// Reads the first frames of a stream without timestamps: only their arrival tells how many come per second. Frames of
/// a pipe that come faster than stated are those of a file.
void LiveSource::learn_rate() {
    constexpr std::size_t most = 16;
    constexpr double longest = 2;  // seconds
    std::vector<double> steps;
    while (first_.size() < most && seconds_between(begin_, Clock::now()) < longest) {
        AvFrame image = decoder_->next();
        if (!image) break;
        steps.push_back(seconds_between(first_.back().when, Clock::now()));
        first_.push_back({std::move(image), Clock::now()});
    }
    if (steps.empty()) return;
    const auto middle = steps.begin() + std::ssize(steps) / 2;
    std::ranges::nth_element(steps, middle);
    const double rate = 1 / *middle;
    constexpr double faster = 1.5;
    if (waits_ && rate > faster * info_.rate) return;
    if (rate <= fastest) info_.rate = rate;
    clock_ = LiveClock(1 / info_.rate, waits_, true);
}

void LiveSource::run(const std::stop_token& stop) {
    try {
        do {
            const std::int64_t damaged_before = damaged();
            while (!first_.empty() && add(std::move(first_.front().image), first_.front().when, stop)) {
                {
                    const std::lock_guard lock(mutex_);
                    damaged_ = damaged_before + decoder_->damaged();
                }
                first_.pop_front();
                if (!first_.empty()) continue;
                if (AvFrame image = decoder_->next()) first_.push_back({std::move(image), Clock::now()});
            }
        } while (reconnect(stop));
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
}

bool LiveSource::is_over() const {
    if (watchdog_->stopped()) return true;
    if (!options_.duration) return false;
    // A stream that can be read faster than real time ends by its own timestamps.
    const double passed = reconnects_ ? seconds_between(begin_, Clock::now()) : 0;
    return std::max(time_, passed) >= *options_.duration;
}

/// \returns whether the stream goes on
bool LiveSource::add(AvFrame image, Clock::time_point now, const std::stop_token& stop) {
    const double before = time_;
    time_ = clock_(demuxer_->seconds(image->best_effort_timestamp), seconds_between(begin_, now));
    if (is_over()) return false;
    const bool after_gap = index_ >= 0 && time_ - before >= gap;
    index_ += after_gap ? std::max<std::int64_t>(1, std::llround((time_ - before) * info_.rate)) : 1;
    auto frame = std::make_unique<DecodedFrame>(DecodedFrame{index_, time_, orientation_, std::move(image)});

    std::unique_lock lock(mutex_);
    const std::int64_t pixels = pixels_of(*frame);
    if (waits_) {
        changed_.wait(lock, stop, [&] {
            return waiting_.empty() || watchdog_->stopped() ||
                   (waiting_.size() < frames_of_a_pipe && waiting_pixels() + pixels <= pixels_waiting);
        });
    }
    while (waiting_.size() > 1 && waiting_pixels() + pixels > pixels_waiting) {
        drop_oldest();
    }
    waiting_.push_back({std::move(frame), now});
    arrivals_.push_back({index_, now});
    if (arrivals_.size() > arrivals_kept) arrivals_.pop_front();
    changed_.notify_all();
    return !stop.stop_requested();
}

/// Waits before the next attempt to reconnect.
/// \returns false if the stream has reached its duration or was stopped
bool LiveSource::pause(const std::stop_token& stop, double seconds) {
    const Clock::time_point until =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    std::unique_lock lock(mutex_);
    while (Clock::now() < until && !stop.stop_requested() && !is_over()) {
        constexpr std::chrono::milliseconds tick(100);  // the duration may end during the pause
        changed_.wait_for(lock, tick);
    }
    return !stop.stop_requested() && !is_over();
}

bool LiveSource::reconnect(const std::stop_token& stop) {
    if (!reconnects_ || is_over() || stop.stop_requested()) return false;
    const Clock::time_point lost = Clock::now();
    options_.report(fmt::format("lost the connection to '{}' after {:.0f} s: {}", input_.name, time_,
                                watchdog_->expired() ? fmt::format("no data for {:g} s", options_.patience)
                                                     : demuxer_->log().text(AVERROR_EOF)));
    {
        const std::lock_guard lock(mutex_);
        lost_since_ = time_;
    }
    std::string reported;
    for (double wait = first_pause; pause(stop, wait); wait = std::min(2 * wait, longest_pause)) {
        try {
            connect();
        } catch (const Error& error) {
            // Reports the same error only once.
            if (error.what() != reported) options_.report(fmt::format("{}; trying again", error.what()));
            reported = error.what();
            continue;
        }
        options_.report(
            fmt::format("reconnected to '{}' after {:.1f} s", input_.name, seconds_between(lost, Clock::now())));
        const std::lock_guard lock(mutex_);
        ++reconnections_;
        lost_since_.reset();
        return true;
    }
    return false;
}

/// Call with the mutex held. Counts each frame, because a stream may change its picture size.
std::int64_t LiveSource::waiting_pixels() const {
    std::int64_t pixels = 0;
    for (const Waiting& waiting : waiting_) pixels += pixels_of(*waiting.frame);
    return pixels;
}

/// Call with the mutex held, if there are two or more. The next frame tells that this one is missing.
void LiveSource::drop_oldest() {
    const std::int64_t dropped = waiting_.front().frame->index;
    waiting_.pop_front();
    DecodedFrame& next = *waiting_.front().frame;
    if (next.index == dropped + 1) next.before = condition::Kind::dropped;
    ++dropped_;
}

/// Call with the mutex held.
void LiveSource::drop_late_frames() {
    const Clock::time_point now = Clock::now();
    while (waiting_.size() > 1 && seconds_between(waiting_.front().since, now) > options_.lag) drop_oldest();
}

std::unique_ptr<DecodedFrame> LiveSource::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !waiting_.empty() || ended_; });
    if (waiting_.empty()) {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
        return nullptr;
    }
    if (!waits_) drop_late_frames();
    std::unique_ptr<DecodedFrame> frame = std::move(waiting_.front().frame);
    waiting_.pop_front();
    changed_.notify_all();
    return frame;
}

std::vector<Frame> LiveSource::sample(int) {
    throw Error(ErrorCode::options_conflict,
                fmt::format("'{}': a live stream has no median; use the reference 'running', 'first' or a picture",
                            input_.name),
                {"reference"});
}

void LiveSource::stop() {
    watchdog_->stop();
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
}

std::int64_t LiveSource::damaged() const {
    const std::lock_guard lock(mutex_);
    return damaged_;
}

std::int64_t LiveSource::dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
}

std::int64_t LiveSource::reconnections() const {
    const std::lock_guard lock(mutex_);
    return reconnections_;
}

std::optional<double> LiveSource::lost_since() const {
    const std::lock_guard lock(mutex_);
    return lost_since_;
}

std::optional<LiveSource::Clock::time_point> LiveSource::arrival(std::int64_t index) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(arrivals_, index, &Arrival::index);
    return found == arrivals_.end() ? std::nullopt : std::optional(found->when);
}

}  // namespace vvr::media
