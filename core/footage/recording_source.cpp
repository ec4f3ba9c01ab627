#include "core/footage/recording_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/media/container.h"
#include "core/media/frame_sampler.h"

namespace vvr::footage {

namespace {

constexpr double tolerance = 1;  // seconds; headers are rounded

// With fewer files, all headers are read first, for an exact total duration.
constexpr std::size_t few = 31;

constexpr double likely_rate = 25;

constexpr std::size_t named = 5;  // limit for names of omitted files

/// Seconds between two frames that are decoded.
double frame_duration(const media::VideoInfo& info) {
    return 1 / (info.rate > 0 ? info.rate : likely_rate);
}

/// Seconds between two frames of the file, decoded or not.
double full_frame_duration(const media::VideoInfo& info) {
    return 1 / (info.rate > 0 ? info.rate / info.decoded_share : likely_rate);
}

/// Converts a segment's time to the recording's time. It rounds to the time base, so the result is bit-identical to
/// that of a single clip. Decisions at whole seconds depend on it.
double on_clock(double begin, double time, double tick) {
    return static_cast<double>(std::llround(begin / tick) + std::llround(time / tick)) * tick;
}

}  // namespace

RecordingSource::RecordingSource(Recording recording, const media::SourceOptions& options)
    : recording_(std::move(recording)), options_(options) {
    // A file knows neither how long the recording is nor what the next one decodes.
    options_.layers = 0;
    if (!open_next()) {
        throw Error(ErrorCode::not_video, fmt::format("cannot read any of the {} of '{}': {}",
                                                      counted(std::ssize(recording_.segments), "file"), recording_.name,
                                                      problems_.empty() ? "it has no files" : problems_.front()));
    }
    const media::VideoInfo before = std::exchange(info_, segment_->info());
    info_.segments = before.segments;
    info_.unread = before.unread;
    info_.name = recording_.name;
    info_.title = recording_.camera;
    info_.began = origin_;
    info_.began_source = origin_source_;
    field_size_ = media::field_size_for(info_.size, options_.field_size);
    numbers_ = media::FrameNumbers(1 / frame_duration(info_));
    estimate_length();
}

/// Estimates the duration: from all headers for few files, from the start of the last file for many.
void RecordingSource::estimate_length() {
    const std::vector<Segment>& segments = recording_.segments;
    const double rate = 1 / frame_duration(info_);
    if (segments.size() > few) {
        const auto last = segments.back().begin;
        const double length = last && origin_ ? static_cast<double>(*last - *origin_) + info_.duration
                                              : info_.duration * static_cast<double>(segments.size());
        info_.duration = length;
        info_.frames = std::llround(length * rate);
        return;
    }
    std::int64_t frames = 0;
    std::optional<double> end;
    for (const Segment& segment : segments) {
        try {
            const media::ClipHeader header = media::header_of(media::Demuxer(
                media::open_track(segment.path, options_.track), media::Demuxer::Kind::video, options_.rate));
            const SegmentBegin begin = begin_of(segment, origin_, end);
            const double gap = end ? std::max(0.0, begin.time - *end) : 0;
            const double decoded = static_cast<double>(header.frames) * info_.decoded_share;
            frames += std::llround(decoded) + std::llround(gap * rate);
            end = begin.time + header.length;
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::limit) throw;
            continue;  // reported when it is read
        }
    }
    info_.duration = end.value_or(0);
    info_.frames = frames;
}

void RecordingSource::fit_size(double seconds) {
    if (seconds <= 0) return;
    std::optional<double> end;
    const std::vector<Segment>& segments = recording_.segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool next_known = origin_ && i + 1 < segments.size() && segments[i + 1].begin;
        if (next_known && static_cast<double>(*segments[i + 1].begin - *origin_) <= seconds) continue;
        try {
            const media::FileSource file(media::open_track(segments[i].path, options_.track), options_);
            const double begin = begin_of(segments[i], origin_, i == 0 ? 0 : end.value_or(seconds)).time;
            end = begin + file.info().duration;
            if (*end <= seconds && i + 1 < segments.size()) continue;
            info_.size = file.info().size;
            field_size_ = file.field_size();
            return;
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::limit) throw;
            continue;  // reported when it is read
        }
    }
}

bool RecordingSource::open_next() {
    while (next_segment_ < recording_.segments.size()) {
        const Segment& segment = recording_.segments[next_segment_++];
        try {
            segment_ = std::make_unique<media::FileSource>(media::open_track(segment.path, options_.track), options_);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::not_video && error.kind() != ErrorKind::io) throw;
            problems_.emplace_back(error.what());
            ++info_.unread;
            continue;
        }
        const bool is_first = index_ < 0;
        if (is_first) {
            origin_ = segment.begin;
            origin_source_ = segment.begin_source;
        }
        begin_ = begin_of(segment, origin_, is_first ? std::nullopt : std::optional(covered_ + frame_));
        frame_ = full_frame_duration(segment_->info());
        first_of_segment_ = true;
        info_.segments.push_back({segment.path, begin_.time, begin_.time, index_ + 1});
        return true;
    }
    return false;
}

/// Reports the frames of a segment that overlap earlier segments.
void RecordingSource::count_overlap() {
    constexpr double usual = 5;  // seconds of pre-recording and of rounding in names
    const std::int64_t frames = std::exchange(left_out_, 0);
    if (frames == 0) return;
    const double seconds = static_cast<double>(frames) * frame_duration(segment_->info());
    const std::string& name = segment_->info().name;
    if (first_of_segment_) {
        info_.left_out.files += 1;
        info_.left_out.frames += frames;
        info_.left_out.seconds += seconds;
        if (info_.left_out.first.size() < named) info_.left_out.first.push_back(name);
        return;
    }
    if (seconds > usual) {
        problems_.push_back(
            fmt::format("'{}' overlaps the previous file; omitted: {}", name, counted(frames, "frame")));
        return;
    }
    trimmed_.files += 1;
    trimmed_.frames += frames;
    trimmed_.seconds += seconds;
}

std::string text_of(const media::OmittedFrames& left_out) {
    const auto rest = left_out.files - std::ssize(left_out.first);
    return fmt::format(
        "{} {} omitted, because other files cover the same time: '{}'{}; {}, {:.1f} s; check whether they are copies, "
        "or from another camera",
        counted(left_out.files, "file"), left_out.files == 1 ? "was" : "were", fmt::join(left_out.first, "', '"),
        rest > 0 ? fmt::format(" and {} more", rest) : "", counted(left_out.frames, "frame"), left_out.seconds);
}

std::vector<std::string> RecordingSource::problems() const {
    std::vector<std::string> problems;
    if (info_.left_out.files > 0) problems.push_back(text_of(info_.left_out));
    if (trimmed_.files > 0) {
        problems.push_back(fmt::format("{} {} the previous file by at most 5 s; omitted: {}, {:.1f} s in all",
                                       counted(trimmed_.files, "file"), trimmed_.files == 1 ? "overlaps" : "overlap",
                                       counted(trimmed_.frames, "frame"), trimmed_.seconds));
    }
    problems.insert(problems.end(), problems_.begin(), problems_.end());
    if (unread_ > damaged()) problems.push_back(media::text_of_unread(info_.name));
    return problems;
}

void RecordingSource::close() {
    const media::VideoInfo& info = segment_->info();
    // The file goes on after its last decoded frame.
    segment_end_ = std::max(segment_end_, segment_->last_in_file() + frame_);
    if (!first_of_segment_) {
        covered_ = std::max(covered_, on_clock(begin_.time, segment_->last_in_file(), segment_->tick()));
        info_.segments.back().end = covered_ + frame_;
    }
    count_overlap();
    if (const std::int64_t damaged = segment_->damaged(); damaged > 0) {
        damaged_ += damaged;
        problems_.push_back(fmt::format("'{}' has {}", info.name, counted(damaged, "damaged packet")));
    } else if (segment_end_ + tolerance < info.duration) {
        problems_.push_back(
            fmt::format("'{}' ends after {:.1f} s, but its header says {:.1f} s; the file is incomplete", info.name,
                        segment_end_, info.duration));
    }
    for (std::string& problem : segment_->problems()) {
        // Report once what holds for many files, such as the fallback to software decoding.
        if (std::ranges::find(problems_, problem) == problems_.end()) problems_.push_back(std::move(problem));
    }
    for (const condition::Interval& interval : segment_->doubtful_times())
        doubtful_times_.push_back({begin_.time + interval.begin, begin_.time + interval.end, interval.kind});
    segment_.reset();
}

std::unique_ptr<media::DecodedFrame> RecordingSource::next() {
    while (segment_ || open_next()) {
        std::unique_ptr<media::DecodedFrame> frame = segment_->next();
        if (!frame) {
            close();
            continue;
        }
        segment_end_ = frame->pts + frame_;
        const double time = on_clock(begin_.time, frame->pts, segment_->tick());
        if (first_of_segment_ && begin_.overlaps && time < covered_ + frame_ / 2) {
            ++left_out_;
            continue;
        }
        const bool after_gap = first_of_segment_ && index_ >= 0 && !begin_.follows && !begin_.overlaps;
        const std::int64_t before = numbers_.last();
        const std::int64_t step = numbers_(time) - before;
        index_ += after_gap ? std::max<std::int64_t>(1, std::llround((time - last_) / frame_duration(info_))) : step;
        if (first_of_segment_) info_.segments.back().first_frame = index_;
        // Of files that overlap, the earlier one shows what it has; its last frame may end within this one.
        for (std::size_t k = 0; first_of_segment_ && begin_.overlaps && k + 1 < info_.segments.size(); ++k)
            info_.segments[k].end = std::min(info_.segments[k].end, time);
        first_of_segment_ = false;
        last_ = std::max(last_, time);
        covered_ = std::max(covered_, last_);
        info_.segments.back().end = covered_ + frame_;
        frame->index = index_;
        frame->pts = last_;
        return frame;
    }
    if (index_ < 0) throw_gone();
    return nullptr;
}

/// Reports that no file can be read any more.
void RecordingSource::throw_gone() const {
    throw Error(ErrorCode::io,
                fmt::format("cannot read any of the {} of '{}' again: {}; check that its folder still exists",
                            counted(std::ssize(recording_.segments), "file"), recording_.name,
                            problems_.empty() ? "they have no frames" : problems_.front()));
}

std::int64_t RecordingSource::damaged() const {
    return damaged_ + (segment_ ? segment_->damaged() : 0);
}

void RecordingSource::rewind() {
    segment_.reset();
    next_segment_ = 0;
    last_ = 0;
    covered_ = 0;
    index_ = -1;
    numbers_ = media::FrameNumbers(1 / frame_duration(info_));
    damaged_ = 0;
    left_out_ = 0;
    trimmed_ = {};
    info_.left_out = {};
    info_.unread = 0;
    problems_.clear();
    doubtful_times_.clear();
    info_.segments.clear();
}

void RecordingSource::read_again(std::span<const double> times,
                                 const std::function<void(std::shared_ptr<media::DecodedFrame>)>& sink) {
    for (std::size_t k = 0; k < info_.segments.size(); ++k) {
        const media::SegmentPlace& place = info_.segments[k];
        const auto end =
            k + 1 < info_.segments.size() ? std::ranges::lower_bound(times, info_.segments[k + 1].begin) : times.end();
        std::vector<double> within;
        for (const double time : times.first(static_cast<std::size_t>(end - times.begin())))
            within.push_back(time - place.begin);
        times = times.subspan(within.size());
        if (within.empty()) continue;
        try {
            media::FileSource source(media::open_input(place.path), options_);
            source.read_again(within, [&](std::shared_ptr<media::DecodedFrame> frame) {
                frame->pts += place.begin;
                sink(std::move(frame));
            });
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::limit) throw;  // others: it was reported if it could not be read before
        }
    }
}

std::vector<media::Frame> RecordingSource::sample(int count) {
    rewind();
    const bool many = std::ssize(recording_.segments) >= std::max(count, static_cast<int>(few));
    unread_ = 0;
    std::vector<media::Frame> frames = many ? sample_segments(count) : sample_key_frames(count);
    if (frames.empty()) {
        frames = sample_all(count);
        unread_ = damaged();
        rewind();
    }
    return frames;
}

/// The first frames of evenly spread segments.
std::vector<media::Frame> RecordingSource::sample_segments(int count) const {
    const auto segments = std::ssize(recording_.segments);
    media::SourceOptions options = options_;
    options.threads = 1;
    media::Scaler scale(field_size_, options_.colour);
    std::vector<media::Frame> frames;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(i * (segments - 1) / std::max(1, count - 1));
        try {
            media::FileSource source(media::open_track(recording_.segments[place].path, options_.track), options);
            frames.push_back(scale(*source.next()));
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::limit) throw;
            continue;  // reported when it is read
        }
    }
    return frames;
}

std::vector<media::Frame> RecordingSource::sample_key_frames(int count) {
    media::KeyFrames keys(count, info_.rate);
    std::optional<double> end;
    for (const Segment& segment : recording_.segments) {
        try {
            end = keys.scan(media::open_track(segment.path, options_.track), options_.rate,
                            begin_of(segment, origin_, end).time);
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::limit) throw;
        }
    }
    unread_ = keys.unread();
    media::Scaler scale(field_size_, options_.colour);
    return keys.decode(options_.rate, options_.threads, scale);
}

}  // namespace vvr::footage
