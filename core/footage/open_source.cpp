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
#include "core/footage/snapshots.h"
#include "core/media/demuxer.h"
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

/// Pictures with the times of their names; null if these have none.
/// \param files none = the input is no pictures
std::unique_ptr<media::FrameSource> open_snapshots(const std::string& name,
                                                   const std::optional<std::vector<std::string>>& files,
                                                   const media::SourceOptions& options, const RecorderNames& schemes,
                                                   std::vector<std::string>& warnings) {
    auto found = files ? find_snapshots(name, *files, schemes, options.join) : std::nullopt;
    if (!found) return nullptr;
    warnings.insert(warnings.end(), found->warnings.begin(), found->warnings.end());
    media::SourceOptions timed = options;
    timed.begin = found->begin;
    if (options.rate == 0) timed.rate = 1 / found->usual;
    for (std::size_t i = 0; options.rate > 0 && i < found->places.size(); ++i) {
        const auto number = static_cast<std::int64_t>(i);
        found->places[i] = {found->places[i].path, static_cast<double>(number) / options.rate,
                            static_cast<double>(number + 1) / options.rate, number};
    }
    return std::make_unique<media::PictureSource>(name, found->camera, std::move(found->places), timed);
}

/// Several files, if all have names of pictures.
std::optional<std::vector<std::string>> pictures_among(const std::vector<std::string>& names) {
    if (names.size() == 1 || !std::ranges::all_of(names, is_picture_name)) return std::nullopt;
    std::vector<std::string> sorted = names;
    std::ranges::sort(sorted, natural_less);
    return sorted;
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
    if (options.rate != 0) check(setting::rate, options.rate);
    const std::string folder = std::filesystem::path(names.front()).parent_path().string();
    if (auto shots = open_snapshots(folder, pictures_among(names), options, schemes, warnings)) return shots;
    if (auto recording = find_recording(names, schemes, options.join, options.rate)) {
        warnings.insert(warnings.end(), recording->warnings.begin(), recording->warnings.end());
        media::SourceOptions paced = options;
        paced.rate = recording->rate;
        return std::make_unique<RecordingSource>(std::move(*recording), paced);
    }
    media::SourceOptions one = options;
    const Segment named = segment_from_name(names.front(), schemes);
    one.begin = named.begin;
    if (named.no_clock) warnings.push_back(fmt::format("'{}': {}", names.front(), text_of_unset_clocks(1)));
    const auto pictures = list_pictures(names.front());
    if (pictures && (options.track > 0 || options.aspect)) {
        warnings.push_back(fmt::format("'{}' has pictures, on which track and aspect have no effect", names.front()));
    }
    if (const auto ignored = videos_beside_pictures(names.front())) warnings.push_back(*ignored);
    if (auto shots = open_snapshots(names.front(), pictures, options, schemes, warnings)) return shots;
    if (pictures && (options.rate == 0 || schemes.has_patterns())) {
        warnings.push_back(
            fmt::format("'{}': most names of its pictures give no time, so vvr reads them at {:.6g} frames per second "
                        "(--rate gives another rate, --names describes other names)",
                        names.front(), options.rate > 0 ? options.rate : media::assumed_rate));
    }
    return open_source(names.front(), one);
}

}  // namespace vvr::footage
