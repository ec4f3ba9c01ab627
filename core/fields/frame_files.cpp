#include "core/fields/frame_files.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"

namespace vvr::fields {

namespace fs = std::filesystem;

namespace {

/// The number at the end of a file name.
std::int64_t frame_of(const fs::path& file) {
    const std::string name = file.stem().string();
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    std::int64_t frame = 0;
    const auto [end, error] = std::from_chars(name.data() + digits, name.data() + name.size(), frame);
    if (error == std::errc() && digits < name.size()) return frame;
    throw Error(
        ErrorCode::input_unsuitable,
        fmt::format(
            "'{}': the file name does not end with a frame number; rename the file, for example to frame000012{}",
            file.string(), extension_of(file)));
}

}  // namespace

std::map<std::int64_t, fs::path> files_by_frame(const fs::path& folder,
                                                const std::vector<std::string_view>& extensions) {
    std::map<std::int64_t, fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const fs::path& file = entry.path();
        if (std::ranges::find(extensions, extension_of(file)) == extensions.end()) continue;
        const auto [known, is_new] = files.emplace(frame_of(file), file);
        if (is_new) continue;
        throw Error(ErrorCode::file_invalid, fmt::format("'{}' and '{}' are both of frame {}; remove one of them",
                                                         known->second.string(), file.string(), known->first));
    }
    if (error) {
        throw system_error(error.value(), fmt::format("'{}' can't be read as a folder", folder.string()),
                           fmt::format("name a folder of {} files", fmt::join(extensions, ", ")));
    }
    return files;
}

FrameFiles::FrameFiles(std::string_view setting, const fs::path& folder,
                       const std::vector<std::string_view>& extensions)
    : setting_(setting), folder_(folder), files_(files_by_frame(folder, extensions)) {
    if (!files_.empty()) return;
    throw Error(ErrorCode::file_not_found,
                fmt::format("{}: the folder '{}' has no {} file; it needs one per frame of the clip, such as 000000{}",
                            setting, folder.string(), fmt::join(extensions, ", "), extensions.front()),
                {setting});
}

const fs::path* FrameFiles::find(std::int64_t frame) const {
    const auto file = files_.find(frame);
    return file == files_.end() ? nullptr : &file->second;
}

const fs::path& FrameFiles::of(std::int64_t frame) const {
    if (const fs::path* const file = find(frame)) return *file;
    throw Error(ErrorCode::file_not_found,
                fmt::format("{}: '{}' has no file of frame {}: it has {}, from '{}' to '{}'; give each frame a file "
                            "whose name ends in the frame's number, counted from 0",
                            setting_, folder_.string(), frame, files_.size(),
                            files_.begin()->second.filename().string(), files_.rbegin()->second.filename().string()),
                {setting_});
}

void FrameFiles::check_end(std::int64_t frames) const {
    if (last() < frames) return;
    throw Error(ErrorCode::file_invalid,
                fmt::format("{}: '{}' is of frame {}, but the clip ends with frame {}; give the files of this clip, "
                            "numbered from 0",
                            setting_, files_.rbegin()->second.string(), last(), frames - 1),
                {setting_});
}

}  // namespace vvr::fields
