#include "core/video/playlist.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/ending.h"

namespace vvr::video {
namespace {

constexpr std::array<std::string_view, 7> playlist_formats{
    "hls", "concat", "dash", "imf", "sdp", "vobsub", "webm_dash_manifest"};

}  // namespace

bool is_playlist_name(const std::string& name) {
    const std::string ending = extension_of(name);
    return ending == ".m3u8" || ending == ".m3u";
}

bool is_playlist_format(const AVInputFormat& format) {
    const std::string_view names(format.name);
    return std::ranges::count(playlist_formats, names.substr(0, names.find(','))) > 0;
}

std::string formats_of_clips() {
    std::string names;
    void* place = nullptr;
    while (const AVInputFormat* format = av_demuxer_iterate(&place)) {
        if (is_playlist_format(*format)) continue;
        names += names.empty() ? "" : ",";
        names += format->name;
    }
    return names;
}

}  // namespace vvr::video
