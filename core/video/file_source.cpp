#include "core/video/file_source.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

extern "C" {
#include <libavutil/display.h>
#include <libavutil/parseutils.h>
}

#include "core/error.h"
#include "core/video/scaler.h"

namespace vvr {
namespace {

/// The nearest quarter turn, mirrored or not, to the container's display matrix.
Orientation orientation_of(const AVStream& stream) {
    std::size_t bytes = 0;
    const auto* data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &bytes);
    if (!data || bytes < 9 * sizeof(std::int32_t)) return {};
    const auto* matrix = reinterpret_cast<const std::int32_t*>(data);
    // A pixel (x, y) is shown at (a·x + c·y, b·x + d·y).
    const std::int64_t a = matrix[0], b = matrix[1], c = matrix[3], d = matrix[4];
    if (std::abs(c) > std::abs(a)) return {true, c < 0, b < 0};
    return {false, a < 0, d < 0};
}

/// Pixels are made square by widening the narrower way, so that no detail is lost.
Size shown_size(const AVFrame& frame, AVRational aspect, Orientation orientation) {
    double width = frame.width;
    double height = frame.height;
    const double ratio = aspect.num > 0 && aspect.den > 0 ? av_q2d(aspect) : 1;
    constexpr double plausible = 8;
    if (ratio > 1 && ratio < plausible) width *= ratio;
    if (ratio < 1 && ratio > 1 / plausible) height /= ratio;
    const Size size{static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height))};
    return orientation.transpose ? Size{size.height, size.width} : size;
}

double duration_of(const AVFormatContext& format, const AVStream& stream) {
    if (stream.duration > 0) return static_cast<double>(stream.duration) * av_q2d(stream.time_base);
    return format.duration > 0 ? static_cast<double>(format.duration) / AV_TIME_BASE : 0;
}

std::optional<std::int64_t> creation_time(const AVFormatContext& format) {
    const AVDictionaryEntry* const tag = av_dict_get(format.metadata, "creation_time", nullptr, 0);
    std::int64_t microseconds = 0;
    if (tag == nullptr || av_parse_time(&microseconds, tag->value, 0) < 0) return std::nullopt;
    return microseconds / 1'000'000;
}

}  // namespace

FileSource::FileSource(Input input, const SourceOptions& options)
    : options_(options), reader_(std::move(input), options.rate, options.threads) {
    auto first = reader_.next();
    const auto& name = reader_.input().name;
    if (!first.image)
        throw Error(
            ErrorKind::not_video,
            fmt::format(
                "'{}' has video ({}), but no frame of it decodes: {} damaged packets, {}; `ffprobe` on it may say more",
                name, avcodec_get_name(reader_.demuxer().stream().codecpar->codec_id), reader_.damaged(),
                reader_.demuxer().log().text(AVERROR_INVALIDDATA)));
    describe(*first.image);
    ahead_ = std::make_unique<DecodedFrame>(DecodedFrame{index_++, first.time, orientation_, std::move(first.image)});
}

void FileSource::describe(const AVFrame& first) {
    auto& format = reader_.demuxer().format();
    auto& stream = reader_.demuxer().stream();
    orientation_ = orientation_of(stream);
    const std::string formats = format.iformat->name;
    info_.name = reader_.input().name;
    info_.container = formats.substr(0, formats.find(','));
    info_.codec = avcodec_get_name(stream.codecpar->codec_id);
    info_.size = shown_size(first, av_guess_sample_aspect_ratio(&format, &stream, nullptr), orientation_);
    info_.rate = stream.avg_frame_rate.den > 0 ? av_q2d(stream.avg_frame_rate) : 0;
    info_.duration = duration_of(format, stream);
    info_.frames = stream.nb_frames > 0 ? stream.nb_frames : std::llround(info_.duration * info_.rate);
    info_.created = creation_time(format);
    field_size_ = field_size_for(info_.size, options_.field_size);
}

void FileSource::rewind() {
    seek(0);
}

void FileSource::seek(double seconds) {
    ahead_.reset();
    // Between two ticks of the container's clock, so that counting and decoding agree on which side a frame lies.
    const double tick = av_q2d(reader_.demuxer().stream().time_base);
    from_ = (std::floor(seconds / tick) - 0.5) * tick;
    start_ = from_ > 0 ? reader_.find(from_) : Start{};
    reader_.rewind(start_);
    index_ = start_.packets > 0 ? start_.frames : 0;
}

std::unique_ptr<DecodedFrame> FileSource::next() {
    if (ahead_) return std::move(ahead_);
    for (;;) {
        auto [image, time] = reader_.next();
        if (!image) return nullptr;
        if (start_.packets == 0 || time >= from_)
            return std::make_unique<DecodedFrame>(DecodedFrame{index_++, time, orientation_, std::move(image)});
        reader_.forget_damage();
    }
}

std::vector<Frame> FileSource::sample(int count) {
    auto frames = sample_key_frames(count);
    if (frames.empty()) frames = sample_planned(count);
    if (frames.empty()) return FrameSource::sample(count);
    rewind();
    return frames;
}

/// None where the clip has fewer key frames than asked for, or where they don't decode by themselves.
std::vector<Frame> FileSource::sample_key_frames(int count) const {
    Demuxer scan(reader_.input(), Demuxer::Kind::video, options_.rate);
    const auto keys = find_key_packets(scan, count);
    if (keys.seen < count) return {};

    Decoder decoder(scan, reader_.input().name, 1);
    Scaler scale(*this);
    std::vector<Frame> frames;
    for (const auto& packet : keys.kept)
        if (auto image = decoder.decode_alone(*packet)) frames.push_back(scale(without_index(scan, std::move(image))));
    if (frames.size() < keys.kept.size() / 2 + 1) return {};
    return frames;
}

/// The frames that sampling all of them would give, without decoding what they don't depend on. None where the clip is
/// damaged, or its packets' times are not its frames'.
std::vector<Frame> FileSource::sample_planned(int count) const {
    Demuxer scan(reader_.input(), Demuxer::Kind::video, options_.rate);
    SampledPackets plan = plan_samples(scan, count);
    Demuxer demuxer(reader_.input(), Demuxer::Kind::video, options_.rate);
    Decoder decoder(demuxer, reader_.input().name, options_.threads);
    decoder.follow(std::move(plan.uses));
    Scaler scale(*this);
    std::vector<Frame> frames;
    while (frames.size() < plan.stamps.size()) {
        auto image = decoder.next();
        if (!image || decoder.damaged() > 0) return {};
        if (image->best_effort_timestamp == plan.stamps[frames.size()])
            frames.push_back(scale(without_index(demuxer, std::move(image))));
    }
    return frames;
}

DecodedFrame FileSource::without_index(const Demuxer& demuxer, AvFrame image) const {
    const double origin = reader_.origin();
    const double pts = demuxer.seconds(image->best_effort_timestamp).value_or(origin) - origin;
    return {0, pts, orientation_, std::move(image)};
}

}  // namespace vvr
