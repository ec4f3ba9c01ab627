#include "cli/app/piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/video_encoder.h"
#include "core/video/container.h"
#include "core/video/frame_source.h"
#include "core/video/packet_copy.h"
#include "core/video/recorder_names.h"
#include "core/video/scaler.h"

namespace vvr::app {

namespace {

namespace fs = std::filesystem;

/// Thrown by the writing function, so that the partial file is removed.
struct Stopped {};

/// The encoding of an exact piece. No B-frames, so that times begin at 0.
struct Encoding {
    std::string_view muxer;
    const char* encoder;
    const char* options;
};

/// For each container, the first row with an installed encoder is used.
constexpr const char* h264 = "crf=18,preset=veryfast,bf=0,colorspace=smpte170m,color_range=tv";
constexpr std::array encodings{
    Encoding{"mp4", "libx264", h264},
    Encoding{"mov", "libx264", h264},
    Encoding{"matroska", "libx264", h264},
    Encoding{"mp4", "mpeg4", "b=12000000"},
    Encoding{"mov", "mpeg4", "b=12000000"},
    Encoding{"matroska", "mpeg4", "b=12000000"},
    Encoding{"webm", "libvpx-vp9", "crf=28,b=0,cpu-used=5,deadline=realtime"},
    Encoding{"webm", "libvpx", "crf=10,b=20000000,cpu-used=5,deadline=realtime"},
};

const Encoding& encoding_for(const fs::path& path) {
    const video::ContainerRow& container = video::container_of(path);
    const auto fits = [&](const Encoding& e) { return e.muxer == container.muxer && image::has_encoder(e.encoder); };
    if (const auto found = std::ranges::find_if(encodings, fits); found != encodings.end()) return *found;
    std::vector<std::string_view> others;
    for (const video::ContainerRow& row : video::containers()) {
        if (std::ranges::find(encodings, row.muxer, &Encoding::muxer) != encodings.end()) others.push_back(row.name);
    }
    throw Error(ErrorCode::output_format_unknown,
                fmt::format("cannot write '{}': no installed encoder supports an exact piece as {}; choose {}",
                            path.string(), container.name, fmt::join(others, ", ")),
                {"exact"});
}

/// "2026-11-22T02:12:10+01:00 to 2026-11-22T02:13:40+01:00"; empty = unknown.
std::string time_of_day(const PieceJob& job, double begin, std::optional<double> end) {
    if (!job.clock) return "";
    return end ? fmt::format("{} to {}", job.clock->iso(begin), job.clock->iso(*end)) : job.clock->iso(begin);
}

/// The time of a second of the recording, in seconds since 1970 (UTC); none = unknown.
std::optional<double> utc_at(const PieceJob& job, double seconds) {
    if (job.clock) return static_cast<double>(video::utc_of({job.clock->begin, job.clock->utc_offset})) + seconds;
    return job.created ? std::optional(static_cast<double>(*job.created) + seconds) : std::nullopt;
}

std::string files_of(const PieceJob& job) {
    constexpr std::size_t most = 20;
    std::vector<std::string> names;
    for (const FootagePart& part : job.parts) names.push_back(shown_text(fs::path(part.file.path).filename().string()));
    const std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

/// The metadata of the piece: camera, day, time, and source files.
/// \param begin time of the first frame, in seconds of the recording
/// \param end time of the last frame; none = unknown
video::Tags tags_of(const PieceJob& job, double begin, std::optional<double> end) {
    video::Tags tags;
    if (!job.camera.empty()) tags.emplace_back("title", shown_text(job.camera));
    std::string comment = shown_text(job.camera);
    const std::string day = time_of_day(job, begin, end);
    for (const std::string& words : {day, fmt::format("cut by vvr from {}", files_of(job))}) {
        if (!words.empty()) comment += (comment.empty() ? "" : "; ") + words;
    }
    tags.emplace_back("comment", comment);
    const std::optional<double> made = utc_at(job, begin);
    if (!made) return tags;
    const auto milliseconds = static_cast<std::int64_t>(std::floor(*made * 1000 + 1e-3));
    const std::int64_t rest = ((milliseconds % 1000) + 1000) % 1000;
    const std::string time =
        fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime((milliseconds - rest) / 1000), rest);
    tags.emplace_back("creation_time", time);
    if (video::container_of(job.path).name == ".avi") tags.emplace_back("date", time);  // AVI lacks the other tag
    return tags;
}

/// ", which is 2026-11-22T02:12:10+01:00 to ..."
std::string day_in_words(const PieceJob& job, double begin, double end) {
    const std::string day = time_of_day(job, begin, end);
    return day.empty() ? day : fmt::format(", which is {}", day);
}

/// Warns that the footage ends before the requested end of the piece.
/// \param last time of the piece's last frame
void warn_of_end(const PieceJob& job, double last, Observer& observer) {
    if (!job.warns_of_early_end) return;
    observer.warn(fmt::format("'{}' ends at {:.3f} s, earlier than the requested end of the piece", job.name, last));
}

// ---- A copy

std::vector<video::CopyPart> parts_to_copy(const PieceJob& job) {
    std::vector<video::CopyPart> copied;
    std::optional<double> over;
    for (const FootagePart& part : job.parts) {
        if (part.overlaps) {
            throw Error(ErrorCode::input_unsuitable,
                        fmt::format("'{}' overlaps the file before it, so a copy would repeat some frames; encode the "
                                    "piece instead of copying it",
                                    part.file.path),
                        {"exact"});
        }
        video::Input input = video::open_input(part.file.path);
        const video::PacketRange piece = video::find_packets(input, job.input.rate, part.span);
        if (piece.frames == 0 && piece.over) over = part.file.begin + *piece.over;
        if (piece.frames > 0) copied.push_back({std::move(input), piece, part.file.begin});
    }
    if (copied.empty()) video::throw_empty(job.name, job.span, over);
    return copied;
}

}  // namespace

std::string_view exact_extension() {
    const auto installed = std::ranges::find_if(encodings, [](const auto& e) { return image::has_encoder(e.encoder); });
    const auto& found = installed == encodings.end() ? encodings.front() : *installed;
    return std::ranges::find(video::containers(), found.muxer, &video::ContainerRow::muxer)->name;
}

void check_exact(const fs::path& path) {
    encoding_for(path);
}

std::optional<PieceTimes> copy_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop) {
    const std::vector<video::CopyPart> parts = parts_to_copy(job);
    const video::CopyPart& first = parts.front();
    const video::CopyPart& last = parts.back();
    const double begin = first.begin + first.piece.begin;
    const double end = last.begin + last.piece.end;
    const video::Tags tags = tags_of(job, begin, end);
    video::CopyResult copied;
    try {
        const auto held = observer.guard();
        const auto write = [&](const WriteAt& write_at) {
            copied = video::copy_pieces(parts, job.input.rate, job.path, tags, write_at,
                                        [&] { return stop.stop_requested(); });
            if (copied.stopped) throw Stopped();
        };
        replace_file(job.path, write, [&](const fs::path& written) {
            video::check_copy(written, parts, copied, job.input.rate, job.shown());
        });
    } catch (const Stopped&) {
        return std::nullopt;
    }
    if (last.piece.ends_early) warn_of_end(job, end, observer);
    std::int64_t damaged = 0;
    for (const video::CopyPart& part : parts) damaged += part.piece.damaged;
    if (damaged > 0) {
        observer.warn(
            fmt::format("'{}': {} copied unchanged into the piece", job.name, counted(damaged, "damaged packet")));
    }
    if (!copied.left_out.empty()) {
        observer.info(fmt::format("'{}': left out streams that are neither video, audio nor subtitles: {}",
                                  job.shown().string(), fmt::join(copied.left_out, ", ")));
    }
    const double before = first.piece.wanted - first.piece.begin;
    const std::string lead = before < 0.0005 ? "" : fmt::format(" {:.3f} s before the piece", before);
    observer.info(fmt::format("'{}': {} copied, {:.3f} s to {:.3f} s of '{}'{}; it begins at a key frame{}",
                              job.shown().string(), counted(copied.packets, "frame"), begin, end, job.name,
                              day_in_words(job, begin, end), lead));
    return PieceTimes{begin, end};
}

// ---- An exact piece

namespace {

/// The first frame of a span in a file.
std::unique_ptr<video::DecodedFrame> first_of(video::FrameSource& clip, const video::FrameSpan& span) {
    if (span.start > 0) clip.seek(span.start - 1);
    auto frame = clip.next();
    while (frame && video::is_before(span, frame->index, frame->pts)) frame = clip.next();
    return frame;
}

struct Encoded {
    std::int64_t frames = 0;
    std::int64_t damaged = 0;
    double begin = 0;
    double end = 0;
};

/// The frames of a piece, from one file after the other.
class PieceFrames {
  public:
    explicit PieceFrames(const PieceJob& job) : job_(job) {
        options_.field_size = {-1, -1};
        options_.colour = true;
        options_.threads = job.threads;
        options_.rate = job.input.rate;
    }

    /// The next frame, with its time in seconds of the recording; null at the end.
    std::unique_ptr<video::DecodedFrame> next() {
        for (;;) {
            if (!file_ && !open()) return nullptr;
            auto frame = ahead_ ? std::move(ahead_) : file_->next();
            const FootagePart& part = *std::prev(part_);
            if (frame && !video::is_past(part.span, frame->index, frame->pts)) {
                const double rate = file_->info().rate;
                const double end = frame->pts + (rate > 0 ? 1 / rate : 0) + 0.002;  // times are rounded
                ends_early_ = !video::is_past(part.span, frame->index + 1, end);
                frame->pts += part.file.begin;
                return frame;
            }
            if (frame) ends_early_ = false;
            damaged_ += file_->damaged();
            file_.reset();
        }
    }

    /// Of the first file that has a frame in the piece.
    const video::VideoInfo& info() const { return *info_; }
    Size size() const { return size_; }
    std::int64_t expected() const { return expected_; }
    std::int64_t damaged() const { return damaged_; }
    /// Whether the last file has neither a frame after the piece nor one that lasts to its end.
    bool ends_early() const { return ends_early_ && (job_.span.end || job_.span.stop); }

  private:
    bool open() {
        if (part_ == job_.parts.end()) return false;
        const FootagePart& part = *part_++;
        file_ = video::open_source(part.file.path, options_);
        expected_ += video::expected_frames(file_->info(), part.span);
        ahead_ = first_of(*file_, part.span);
        if (!info_ && ahead_) {
            info_ = file_->info();
            size_ = file_->field_size();
        }
        return true;
    }

    const PieceJob& job_;
    video::SourceOptions options_;
    std::vector<FootagePart>::const_iterator part_ = job_.parts.begin();
    std::unique_ptr<video::FrameSource> file_;
    std::unique_ptr<video::DecodedFrame> ahead_;
    std::optional<video::VideoInfo> info_;
    Size size_;
    std::int64_t expected_ = 0;
    std::int64_t damaged_ = 0;
    bool ends_early_ = false;
};

/// When the last frame of the piece is shown, in seconds of the recording: the header needs it before that frame is
/// decoded. None if the packets don't tell it.
std::optional<double> last_frame_of(const PieceJob& job) {
    try {
        for (auto part = job.parts.rbegin(); part != job.parts.rend(); ++part) {
            const video::Input input = video::open_input(part->file.path);
            const auto last = video::last_frame_in(input, job.input.rate, part->span);
            if (last) return part->file.begin + *last;
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::not_video) throw;
    }
    return std::nullopt;
}

Encoded encode(const PieceJob& job, PieceFrames& frames, std::unique_ptr<video::DecodedFrame> frame,
               const WriteAt& write_at, Observer& observer, const std::stop_token& stop) {
    constexpr int ticks = 90'000;
    constexpr int default_rate = 25;
    const Encoding& encoding = encoding_for(job.path);
    const double given = frames.info().rate;
    const int rate = given > 0 ? static_cast<int>(std::clamp(std::round(given), 1.0, 1000.0)) : default_rate;
    // Without a clock, the metadata has no end.
    const video::Tags tags = tags_of(job, frame->pts, job.clock ? last_frame_of(job) : std::nullopt);
    image::VideoEncoder film({std::string(encoding.muxer), encoding.encoder, encoding.options, false, tags},
                             job.path.string(), frames.info().size, ticks, rate, 2 * rate, write_at);
    video::Scaler scale(frames.size(), true);
    Encoded encoded{0, 0, frame->pts, frame->pts};
    std::int64_t last_tick = -1;
    for (; frame; frame = frames.next()) {
        if (stop.stop_requested()) throw Stopped();
        // Frames with the same time are shown one after the other.
        last_tick = std::max(last_tick + 1, std::int64_t{std::llround((frame->pts - encoded.begin) * ticks)});
        encoded.end = frame->pts;
        film.add(scale(*frame).colour, last_tick);
        observer.frames(++encoded.frames, frames.expected());
    }
    film.finish();
    encoded.damaged = frames.damaged();
    return encoded;
}

}  // namespace

std::optional<PieceTimes> encode_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop) {
    PieceFrames frames(job);
    auto frame = frames.next();
    if (!frame) video::throw_empty(job.name, job.span, std::nullopt);
    Encoded encoded;
    try {
        const auto held = observer.guard();
        replace_file(job.path, [&](const WriteAt& write_at) {
            encoded = encode(job, frames, std::move(frame), write_at, observer, stop);
        });
    } catch (const Stopped&) {
        return std::nullopt;
    }
    if (frames.ends_early()) warn_of_end(job, encoded.end, observer);
    if (encoded.damaged > 0) {
        observer.warn(fmt::format("'{}': {}; the piece has the frames that could be decoded", job.name,
                                  counted(encoded.damaged, "damaged packet")));
    }
    observer.info(fmt::format("'{}': {} encoded again without sound, {:.3f} s to {:.3f} s of '{}'{}",
                              job.shown().string(), counted(encoded.frames, "frame"), encoded.begin, encoded.end,
                              job.name, day_in_words(job, encoded.begin, encoded.end)));
    return PieceTimes{encoded.begin, encoded.end};
}

FullFrame frame_of(const PieceJob& job, double seconds) {
    PieceJob rest = job;
    rest.span.start = seconds;
    // Of files that overlap, the earlier one is used. The last may go on after file.end, if a search ended there.
    const FootagePart* const last = rest.parts.empty() ? nullptr : &rest.parts.back();
    std::erase_if(rest.parts, [&](const FootagePart& part) { return &part != last && part.file.end <= seconds; });
    if (!rest.parts.empty()) {
        FootagePart& first = rest.parts.front();
        // The moment may be before the piece: what was taken is seen until it went. Times are rounded.
        first.span.start = std::max(0.0, seconds - first.file.begin - 0.0005);
    }
    PieceFrames frames(rest);
    const auto frame = frames.next();
    if (!frame) video::throw_empty(job.name, rest.span, std::nullopt);
    video::Scaler scale(frames.size(), true);
    return {frame->pts, scale(*frame).colour};
}

}  // namespace vvr::app
