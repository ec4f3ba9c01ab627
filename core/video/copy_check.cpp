#include "core/video/copy_check.h"

#include <algorithm>
#include <memory>
#include <vector>

extern "C" {
#include <libavutil/imgutils.h>
}

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/video/demuxer.h"
#include "core/video/file_source.h"

namespace vvr::video {
namespace {

constexpr double slack = 0.002;            // seconds; containers round times
constexpr int checked_frames = 50;         // of each part: what a container can't tell shows at once
constexpr std::size_t checked_parts = 16;  // of a long recording

std::int64_t count_packets(const Input& input, double rate) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    const auto packet = av::make_packet();
    std::int64_t count = 0;
    while (demuxer.read(*packet)) ++count;
    return count;
}

std::vector<std::uint8_t> pixels_of(const AVFrame& image) {
    const auto format = static_cast<AVPixelFormat>(image.format);
    std::vector<std::uint8_t> pixels(
        static_cast<std::size_t>(std::max(0, av_image_get_buffer_size(format, image.width, image.height, 1))));
    av_image_copy_to_buffer(pixels.data(), static_cast<int>(pixels.size()), image.data, image.linesize, format,
                            image.width, image.height, 1);
    return pixels;
}

bool are_same(const AVFrame& a, const AVFrame& b) {
    return a.format == b.format && a.width == b.width && a.height == b.height && pixels_of(a) == pixels_of(b);
}

std::unique_ptr<DecodedFrame> frame_from(FrameSource& source, double seconds) {
    source.seek(std::max(0.0, seconds - slack));
    auto frame = source.next();
    while (frame && frame->pts < seconds - slack) frame = source.next();
    return frame;
}

/// Whether the copy shows at the beginning of a part what the file shows, as far as that decodes.
bool begins_alike(FileSource& copy, double begin, const CopyPart& part, const SourceOptions& options) {
    FileSource file(part.input, options);
    auto wanted = frame_from(file, part.piece.begin);
    auto found = frame_from(copy, begin);
    for (int i = 0; i < checked_frames && wanted && wanted->pts < part.piece.end + slack; ++i) {
        if (file.damaged() > 0) return true;
        if (!found || !are_same(*wanted->image, *found->image)) return false;
        wanted = file.next();
        found = copy.next();
    }
    return true;
}

}  // namespace

void check_copy(const std::filesystem::path& copy, std::span<const CopyPart> parts, const CopyResult& copied, double rate,
                const std::filesystem::path& path) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::not_video,
                    fmt::format("'{}' would not show what '{}' does: {}; choose the ending of that file, or cut it "
                                "exactly, which encodes the video anew",
                                path.string(), parts.front().input.name, what),
                    {"exact"});
    };
    const Input input = open_input(copy.string());
    SourceOptions options;
    options.threads = 1;
    options.rate = rate;
    std::unique_ptr<FileSource> written;
    try {
        const std::int64_t packets = count_packets(input, rate);
        if (packets != copied.packets)
            refuse(fmt::format("{} of {} frames can be read again", packets, copied.packets));
        written = std::make_unique<FileSource>(input, options);
    } catch (const Error& error) {
        if (error.about().names().empty()) refuse("its frames don't decode there");
        throw;
    }
    const double zero = parts.front().begin + parts.front().piece.begin;
    for (const CopyPart& part : parts.first(std::min(parts.size(), checked_parts))) {
        if (begins_alike(*written, part.begin + part.piece.begin - zero, part, options)) continue;
        refuse(fmt::format("from {:.3f} s on, where a key frame should be, other pictures come out", part.piece.begin));
    }
}

}  // namespace vvr::video
