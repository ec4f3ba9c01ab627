#include "core/video/container.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/video/demuxer.h"

namespace vvr::video {
namespace {

constexpr std::array table{
    ContainerRow{".mp4", "mp4"},      ContainerRow{".mov", "mov"},   ContainerRow{".m4v", "mp4"},
    ContainerRow{".mkv", "matroska"}, ContainerRow{".webm", "webm"}, ContainerRow{".avi", "avi"},
};

bool holds(const char* muxer, AVCodecID codec) {
    const AVOutputFormat* const format = av_guess_format(muxer, nullptr, nullptr);
    // Matroska can hold AVI codecs by their AVI tags. libav calls that unofficial, but every player supports it.
    return format != nullptr && avformat_query_codec(format, codec, FF_COMPLIANCE_UNOFFICIAL) == 1;
}

bool holds_all(const ContainerRow& row, const AVFormatContext& clip) {
    return std::ranges::all_of(media_of(clip),
                               [&](const AVStream* stream) { return holds(row.muxer, stream->codecpar->codec_id); });
}

bool is_media(const AVStream& stream) {
    const AVMediaType type = stream.codecpar->codec_type;
    return (type == AVMEDIA_TYPE_VIDEO || type == AVMEDIA_TYPE_AUDIO || type == AVMEDIA_TYPE_SUBTITLE) &&
           (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) == 0;
}

}  // namespace

std::span<const ContainerRow> containers() {
    return table;
}

const ContainerRow& container_of(const std::filesystem::path& path) {
    const auto row = std::ranges::find(table, extension_of(path), &ContainerRow::name);
    if (row != table.end()) return *row;
    throw Error(ErrorCode::output_format_unknown, fmt::format("cannot write '{}': the name of a clip ends in {}",
                                                              path.string(), fmt::join(names_of(table), ", ")));
}

std::vector<const AVStream*> media_of(const AVFormatContext& clip) {
    std::vector<const AVStream*> streams;
    for (unsigned i = 0; i < clip.nb_streams; ++i) {
        if (is_media(*clip.streams[i])) streams.push_back(clip.streams[i]);
    }
    return streams;
}

void check_container(const ContainerRow& container, const AVFormatContext& clip, const std::filesystem::path& path) {
    if (holds_all(container, clip)) return;
    const std::vector<const AVStream*> streams = media_of(clip);
    const auto refused = std::ranges::find_if(
        streams, [&](const AVStream* s) { return !holds(container.muxer, s->codecpar->codec_id); });
    std::vector<std::string_view> others;
    for (const ContainerRow& row : table) {
        if (holds_all(row, clip)) others.push_back(row.name);
    }
    throw Error(ErrorCode::options_conflict,
                fmt::format("cannot write '{}': {} can't hold {}; {}cut it exactly, which encodes the video anew",
                            path.string(), container.name, name_of(**refused),
                            others.empty() ? "" : fmt::format("choose {}, or ", fmt::join(others, ", "))),
                {"exact"});
}

std::string_view extension_for(const Input& clip, double rate) {
    const Demuxer demuxer(clip, Demuxer::Kind::video, rate);
    const auto own = std::ranges::find(table, extension_of(clip.name), &ContainerRow::name);
    if (own != table.end() && holds_all(*own, demuxer.format())) return own->name;
    const auto row = std::ranges::find_if(table, [&](const auto& each) { return holds_all(each, demuxer.format()); });
    return row == table.end() ? std::string_view() : row->name;
}

}  // namespace vvr::video
