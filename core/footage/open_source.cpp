#include "core/footage/open_source.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/footage/input_files.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"
#include "core/footage/recording_source.h"
#include "core/media/file_source.h"
#include "core/media/input.h"
#include "core/media/picture_source.h"
#include "core/media/settings.h"

namespace vvr::footage {

namespace {

/// A warning if a folder of pictures also has videos, which are ignored.
std::optional<std::string> videos_beside_pictures(const std::string& folder) {
    std::error_code none;
    if (!std::filesystem::is_directory(folder, none)) return std::nullopt;
    std::vector<std::string> videos = video_files_in(folder);
    if (videos.empty()) return std::nullopt;
    std::ranges::sort(videos, natural_less);
    return fmt::format("'{}' has pictures, which vvr reads as one clip; {} in it {} ignored: '{}'{}", folder,
                       counted(std::ssize(videos), "video"), videos.size() == 1 ? "is" : "are", videos.front(),
                       videos.size() == 1 ? "" : " and others");
}

}  // namespace

std::unique_ptr<media::FrameSource> open_source(const std::string& name, const media::SourceOptions& options) {
    if (options.rate != 0) check(setting::rate, options.rate);
    if (auto files = list_pictures(name))
        return std::make_unique<media::PictureSource>(name, std::move(*files), options);
    return std::make_unique<media::FileSource>(media::open_track(name, options.track), options);
}

std::unique_ptr<media::FrameSource> open_sources(const std::vector<std::string>& names,
                                                 const media::SourceOptions& options, const RecorderNames& schemes,
                                                 std::vector<std::string>& warnings) {
    if (auto recording = find_recording(names, schemes, options.join, options.rate)) {
        if (options.rate != 0) check(setting::rate, options.rate);
        warnings.insert(warnings.end(), recording->warnings.begin(), recording->warnings.end());
        return std::make_unique<RecordingSource>(std::move(*recording), options);
    }
    media::SourceOptions one = options;
    const Segment named = segment_from_name(names.front(), schemes);
    one.begin = named.begin;
    if (named.no_clock) warnings.push_back(fmt::format("'{}': {}", names.front(), text_of_unset_clocks(1)));
    if ((schemes.has_patterns() || options.track > 0 || options.aspect) && list_pictures(names.front())) {
        warnings.push_back(
            fmt::format("'{}' has pictures, on which names, track and aspect have no effect; --rate and "
                        "--start-time give their times",
                        names.front()));
    }
    if (const auto ignored = videos_beside_pictures(names.front())) warnings.push_back(*ignored);
    return open_source(names.front(), one);
}

}  // namespace vvr::footage
