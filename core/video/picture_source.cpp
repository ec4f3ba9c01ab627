#include "core/video/picture_source.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

extern "C" {
#include <libavutil/frame.h>
}

#include "core/base/error.h"
#include "core/video/decoder.h"
#include "core/video/demuxer.h"
#include "core/video/input.h"
#include "core/video/scaler.h"
#include "core/video/video_files.h"

namespace vvr::video {
namespace {

namespace fs = std::filesystem;

/// The names of the regular files in a folder, without hidden files.
std::vector<std::string> files_in(const fs::path& folder, const std::string& asked) {
    std::vector<std::string> names;
    std::error_code why;
    for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, why);
         !why && entry != fs::directory_iterator(); entry.increment(why)) {
        std::error_code ignored;
        std::string file = entry->path().filename().string();
        if (!file.starts_with('.') && entry->is_regular_file(ignored)) names.push_back(std::move(file));
    }
    if (why) {
        throw Error(
            code_of_system_error(why.value()),
            fmt::format("cannot read the folder of '{}': {}; check its name and permissions", asked, why.message()));
    }
    return names;
}

std::vector<std::string> pictures_in(const std::string& folder) {
    const auto names = files_in(folder, folder);
    std::vector<std::string> pictures;
    for (const auto& name : names) {
        if (is_picture_name(name)) pictures.push_back((fs::path(folder) / name).string());
    }
    if (pictures.empty()) {
        throw Error(
            ErrorCode::not_video,
            fmt::format(
                "'{}' is a folder without frames: {}; give a video file, or a folder of pictures (png, jpg, tif, ...)",
                folder,
                names.empty() ? std::string("it holds no file")
                              : fmt::format("none of its {} file(s) is a picture", names.size())));
    }
    return pictures;
}

std::vector<std::string> expand_glob_pattern(const std::string& pattern) {
    std::vector<std::string> files;
    for (std::string& match : expand_glob(pattern)) {
        std::error_code ignored;
        if (fs::is_regular_file(match, ignored)) files.push_back(std::move(match));
    }
    return files;
}

/// The parts of "frame%05d.png": the text before and after the number, and its minimum width.
struct NumberPattern {
    std::string before;
    std::string after;
    std::size_t width = 0;
    bool zeros = false;
};

[[noreturn]] void throw_bad_pattern(const std::string& name) {
    throw Error(ErrorCode::name_pattern_invalid,
                fmt::format("'{}': a pattern of pictures has one number in its file name, written %d or "
                            "%05d, and %% for a percent sign",
                            name));
}

NumberPattern parse_pattern(std::string_view file, const std::string& name) {
    NumberPattern pattern;
    bool has_number = false;
    while (!file.empty()) {
        std::string& literal = has_number ? pattern.after : pattern.before;
        const char c = file.front();
        file.remove_prefix(1);
        if (c != '%') {
            literal += c;
            continue;
        }
        if (file.starts_with('%')) {
            literal += '%';
            file.remove_prefix(1);
            continue;
        }
        pattern.zeros = file.starts_with('0');
        const auto end = file.find_first_not_of("0123456789");
        if (has_number || end == std::string_view::npos || end > 3 ||
            (file[end] != 'd' && file[end] != 'i' && file[end] != 'u')) {
            throw_bad_pattern(name);
        }
        std::from_chars(file.data(), file.data() + end, pattern.width);
        file.remove_prefix(end + 1);
        has_number = true;
    }
    if (!has_number) throw_bad_pattern(name);
    return pattern;
}

bool matches(const NumberPattern& pattern, std::string_view file) {
    if (file.size() <= pattern.before.size() + pattern.after.size()) return false;
    if (!file.starts_with(pattern.before) || !file.ends_with(pattern.after)) return false;
    const auto number = file.substr(pattern.before.size(), file.size() - pattern.before.size() - pattern.after.size());
    if (number.find_first_not_of("0123456789") != std::string_view::npos) return false;
    if (number.size() < (pattern.zeros ? pattern.width : 1)) return false;
    // printf pads only up to the width.
    return number.size() == 1 || number.front() != '0' || (pattern.zeros && number.size() == pattern.width);
}

std::vector<std::string> matches_of_pattern(const std::string& name) {
    const fs::path path(name);
    if (path.parent_path().string().find('%') != std::string::npos && !fs::exists(path.parent_path())) {
        throw_bad_pattern(name);
    }
    const auto pattern = parse_pattern(path.filename().string(), name);
    std::vector<std::string> files;
    for (const auto& file : files_in(path.parent_path(), name)) {
        if (matches(pattern, file)) files.push_back((path.parent_path() / file).string());
    }
    return files;
}

}  // namespace

std::optional<std::vector<std::string>> list_pictures(const std::string& name) {
    std::error_code ignored;
    const auto status = fs::status(name, ignored);
    const bool is_folder = fs::is_directory(status);
    const bool has_wildcard = name.find_first_of("%*?[") != std::string::npos;
    if (!is_folder && (name == "-" || fs::exists(status) || is_url(name) || !has_wildcard)) return std::nullopt;

    std::vector<std::string> files;
    if (is_folder) {
        files = pictures_in(name);
    } else if (name.find('%') != std::string::npos) {
        files = matches_of_pattern(name);
    } else {
        files = expand_glob_pattern(name);
    }
    if (files.empty()) {
        throw Error(ErrorCode::file_not_found,
                    fmt::format("cannot read '{}': no file matches this pattern; check it and the folder", name));
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return natural_less(a, b); });
    return files;
}

namespace {

struct Picture {
    AvFrame image;
    std::string codec;
};

/// \throws Error io, not_video, limit
Picture decode_picture(const std::string& path) {
    Demuxer demuxer(open_file(path), Demuxer::Kind::picture, 25);
    Decoder decoder(demuxer, path, 1);
    Picture picture{decoder.next(), avcodec_get_name(demuxer.stream().codecpar->codec_id)};
    if (!picture.image) throw Error(ErrorCode::no_frame, demuxer.log().text(AVERROR_INVALIDDATA));
    return picture;
}

/// Null for a picture that can't be read or decoded, which then counts as a damaged frame.
AvFrame try_decode_picture(const std::string& path) {
    try {
        return decode_picture(path).image;
    } catch (const Error&) {
        return nullptr;
    }
}

/// Index of the first file at or after `time`, with a tolerance for rounded decimals.
std::size_t file_at(double time, double rate, std::size_t files) {
    return static_cast<std::size_t>(std::clamp(std::ceil(time * rate - 1e-6), 0.0, static_cast<double>(files)));
}

}  // namespace

PictureSource::PictureSource(const std::string& name, std::vector<std::string> files, const SourceOptions& options)
    : files_(std::move(files)), options_(options) {
    const double duration = static_cast<double>(files_.size()) / options.rate;
    std::string why;
    for (const std::string& file : files_) {
        try {
            const auto first = decode_picture(file);
            info_ = {name,
                     "pictures",
                     first.codec,
                     {first.image->width, first.image->height},
                     options.rate,
                     duration,
                     static_cast<std::int64_t>(files_.size())};
            break;
        } catch (const Error& error) {
            if (why.empty()) why = fmt::format("{}: {}", file, error.what());
        }
    }
    if (info_.frames == 0) {
        throw Error(ErrorCode::no_frame,
                    fmt::format("'{}': none of its {} pictures decodes; the first: {}", name, files_.size(), why));
    }
    field_size_ = field_size_for(info_.size, options.field_size);
}

std::unique_ptr<DecodedFrame> PictureSource::frame(std::size_t file, AvFrame image) const {
    return std::make_unique<DecodedFrame>(
        DecodedFrame{static_cast<std::int64_t>(file), static_cast<double>(file) / options_.rate, {}, std::move(image)});
}

std::unique_ptr<DecodedFrame> PictureSource::next() {
    const auto cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t threads = options_.threads > 0 ? static_cast<std::size_t>(std::min(options_.threads, 64)) : cores;
    while (next_ < files_.size()) {
        while (ahead_.size() < threads && next_ + ahead_.size() < files_.size()) {
            ahead_.push_back(
                std::async(std::launch::async, try_decode_picture, std::cref(files_[next_ + ahead_.size()])));
        }
        auto image = ahead_.front().get();
        ahead_.pop_front();
        const std::size_t file = next_++;
        if (image) return frame(file, std::move(image));
        ++damaged_;
    }
    return nullptr;
}

void PictureSource::rewind() {
    seek(0);
}

void PictureSource::seek(double seconds) {
    ahead_.clear();
    next_ = file_at(seconds, options_.rate, files_.size());
    damaged_ = 0;
}

std::vector<Frame> PictureSource::sample(int count) {
    const std::size_t files = files_.size();
    const std::size_t wanted = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, count)), 1, files);
    Scaler scale(*this);
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t file = (2 * i + 1) * files / (2 * wanted);
        if (auto image = try_decode_picture(files_[file])) frames.push_back(scale(*frame(file, std::move(image))));
    }
    if (2 * frames.size() > wanted) {
        rewind();
        return frames;
    }
    return FrameSource::sample(count);
}

}  // namespace vvr::video
