#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/plane.h"
#include "core/base/text.h"
#include "core/video/av.h"
#include "core/video/file_source.h"
#include "core/video/frame_source.h"
#include "core/video/frame_times.h"
#include "core/video/input.h"
#include "core/video/picture_source.h"
#include "core/video/recorder_names.h"
#include "core/video/recording.h"
#include "core/video/recording_source.h"
#include "core/video/scaler.h"
#include "core/video/settings.h"
#include "core/video/video_files.h"

namespace vvr::video {

std::vector<Frame> FrameSource::sample(int count) {
    rewind();
    Scaler scale(*this);
    TimeSampler<Frame> sampler(count);
    while (const auto decoded = next()) {
        if (sampler.wants(decoded->pts)) sampler.keep(decoded->pts, scale(*decoded));
    }
    rewind();
    return sampler.take();
}

Size field_size_for(Size shown, Size asked) {
    constexpr int default_long_side = 384;
    constexpr Size automatic{0, 0};
    constexpr Size source{-1, -1};
    Size size = asked == source ? shown : asked;
    if (asked == automatic) size = fit_into(shown, default_long_side);
    if (size.width < 1 || size.height < 1) {
        throw Error(ErrorCode::option_value_out_of_range,
                    fmt::format("a field of {}x{} pixels: both sides have to be at least 1", size.width, size.height));
    }
    if (std::int64_t{size.width} * size.height > av::max_pixels) {
        throw Error(
            ErrorCode::picture_too_large,
            fmt::format("a field of {}x{} pixels is more than the {} megapixels that vvr takes; choose smaller fields",
                        size.width, size.height, av::max_pixels / 1'000'000),
            {"field-size"});
    }
    return size;
}

void FrameSource::seek(double) {
    rewind();
}

namespace {

/// A warning if a folder of pictures also has videos, which are ignored.
std::optional<std::string> videos_beside_pictures(const std::string& folder) {
    std::error_code none;
    if (!std::filesystem::is_directory(folder, none)) return std::nullopt;
    std::vector<std::string> videos = video_files_in(folder);
    if (videos.empty()) return std::nullopt;
    std::ranges::sort(videos, natural_less);
    return fmt::format("'{}' holds pictures, which are drawn as one clip; {} in it {} ignored, '{}'{}", folder,
                       counted(std::ssize(videos), "video"), videos.size() == 1 ? "is" : "are", videos.front(),
                       videos.size() == 1 ? "" : " and others");
}

}  // namespace

std::unique_ptr<FrameSource> open_source(const std::string& name, const SourceOptions& options) {
    check(setting::rate, options.rate);
    if (auto files = list_pictures(name)) return std::make_unique<PictureSource>(name, std::move(*files), options);
    return std::make_unique<FileSource>(open_input(name), options);
}

std::unique_ptr<FrameSource> open_sources(const std::vector<std::string>& names, const SourceOptions& options,
                                          const RecorderNames& layouts, std::vector<std::string>& warnings) {
    if (auto recording = find_recording(names, layouts, options.join)) {
        check(setting::rate, options.rate);
        warnings = recording->warnings;
        return std::make_unique<RecordingSource>(std::move(*recording), options);
    }
    SourceOptions one = options;
    one.begin = segment_from_name(names.front(), layouts).begin;
    if (const auto ignored = videos_beside_pictures(names.front())) warnings.push_back(*ignored);
    return open_source(names.front(), one);
}

namespace {

namespace fs = std::filesystem;

using Paths = std::vector<fs::path>;

/// Adds all files that may be read from a folder: videos of its subfolders, pictures, parts of an extraction, lists.
void add_folder(const fs::path& folder, Paths& files) {
    std::error_code none;
    const bool extracted = fs::exists(folder / "manifest.json", none);
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, none);
    for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored)) continue;
        const std::string name = entry->path().filename().string();
        const std::string ending = extension_of(name);
        const bool flat = is_picture_name(name) || ending == ".txt" || ending == ".flo";
        if (extracted || is_video_name(name) || (flat && entry.depth() == 0)) files.push_back(entry->path());
    }
}

/// Adds the files in a list, even if other lines are invalid.
void add_list(const fs::path& list, Paths& files) {
    std::error_code none;
    if (fs::file_size(list, none) > most_list_bytes || none) return;
    std::ifstream text(list);
    for (std::string line; std::getline(text, line);) {
        if (line.ends_with('\r')) line.pop_back();
        const fs::path file = list.parent_path() / line;
        if (!line.empty() && fs::is_regular_file(file, none)) files.push_back(file);
    }
}

void add(const std::string& name, Paths& files) {
    std::error_code none;
    if (fs::is_directory(name, none)) return add_folder(name, files);
    if (fs::is_regular_file(name, none)) {
        files.emplace_back(name);
        if (extension_of(name) == ".txt") add_list(name, files);
        return;
    }
    if (fs::exists(name, none)) return;
    for (const std::string& match : expand_glob(name)) add(match, files);
    if (name.find('%') == std::string::npos) return;
    if (const auto pictures = list_pictures(name)) files.insert(files.end(), pictures->begin(), pictures->end());
}

}  // namespace

Paths files_of_input(const std::string& name) {
    if (name == "-") return {"/dev/stdin"};
    Paths files;
    try {
        add(name, files);
        if (name.starts_with('@')) add(name.substr(1), files);
    } catch (const Error&) {
        return files;
    }
    return files;
}

}  // namespace vvr::video
