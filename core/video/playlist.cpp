#include "core/video/playlist.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;

constexpr int most_playlists = 64;                       // that one may name, its own name included
constexpr std::uintmax_t most_bytes = 16 * 1024 * 1024;  // a day of segments of a second has 4 MB
constexpr std::string_view first_line = "#EXTM3U";
constexpr std::array<std::string_view, 7> playlist_formats{
    "hls", "concat", "dash", "imf", "sdp", "vobsub", "webm_dash_manifest"};

/// The file of an address that libav made out of a playlist's name and a line of it; nothing for another protocol.
std::optional<fs::path> file_of(std::string_view url) {
    for (const std::string_view prefix : {"crypto+file:", "crypto:file:", "file:"}) {
        if (url.starts_with(prefix)) return fs::path(url.substr(prefix.size()));
    }
    return std::nullopt;
}

bool begins_as_playlist(const fs::path& file) {
    std::array<char, first_line.size()> begin{};
    std::ifstream stream(file, std::ios::binary);
    return stream.read(begin.data(), begin.size()) && std::string_view(begin.data(), begin.size()) == first_line;
}

/// All of a playlist, with an end; nothing if it can't be read or is too large.
std::optional<std::string> text_of(const fs::path& file) {
    std::error_code error;
    if (fs::file_size(file, error) > most_bytes || error) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream.good() && !stream.eof()) return std::nullopt;
    return text + "\n#EXT-X-ENDLIST\n";
}

}  // namespace

/// A playlist's text as libav reads it.
class PlaylistFiles::Text {
  public:
    explicit Text(std::string text) : text_(std::move(text)), context_(av::make_reader(this, &Text::read)) {}

    AVIOContext* context() { return context_.get(); }

  private:
    static int read(void* self, std::uint8_t* buffer, int size) {
        auto& text = *static_cast<Text*>(self);
        const std::size_t bytes = std::min(text.text_.size() - text.position_, static_cast<std::size_t>(size));
        if (bytes == 0) return AVERROR_EOF;
        std::memcpy(buffer, text.text_.data() + text.position_, bytes);
        text.position_ += bytes;
        return static_cast<int>(bytes);
    }

    std::string text_;
    std::size_t position_ = 0;
    av::Ptr<AVIOContext> context_;
};

bool is_playlist_name(const std::string& name) {
    std::string extension = fs::path(name).extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
    return extension == ".m3u8" || extension == ".m3u";
}

bool is_playlist_format(const AVInputFormat& format) {
    const std::string_view names(format.name);
    return std::ranges::count(playlist_formats, names.substr(0, names.find(','))) > 0;
}

std::string allowed_formats(bool playlists) {
    std::string names;
    void* place = nullptr;
    while (const AVInputFormat* format = av_demuxer_iterate(&place)) {
        if (is_playlist_format(*format) && !(playlists && std::string_view(format->name).starts_with("hls"))) continue;
        names += names.empty() ? "" : ",";
        names += format->name;
    }
    return names;
}

PlaylistFiles::PlaylistFiles(const fs::path& playlist)
    : folder_(fs::weakly_canonical(fs::absolute(playlist).parent_path())) {
    auto text = text_of(playlist);
    if (!text) {
        throw Error(ErrorKind::limit,
                    fmt::format("'{}' is too large for a playlist, or cannot be read: {} MB are read; "
                                "give the video files themselves",
                                playlist.string(), most_bytes / 1024 / 1024));
    }
    texts_.push_back(std::make_unique<Text>(std::move(*text)));
}

PlaylistFiles::~PlaylistFiles() = default;

void PlaylistFiles::attach(AVFormatContext& format) {
    open_by_name_ = format.io_open;
    format.pb = texts_.front()->context();
    format.opaque = this;
    format.io_open = &PlaylistFiles::open;
    format.io_close2 = &PlaylistFiles::close;
}

bool PlaylistFiles::may_open(const fs::path& file) const {
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (error || !fs::is_regular_file(real, error)) return false;
    const fs::path below = real.lexically_relative(folder_);
    return !below.empty() && *below.begin() != "..";
}

int PlaylistFiles::open(AVFormatContext* format, AVIOContext** opened, const char* url, int flags,
                        AVDictionary** options) {
    auto& self = *static_cast<PlaylistFiles*>(format->opaque);
    const std::optional<fs::path> file = file_of(url);
    if (!file || !self.may_open(*file)) return AVERROR(EPERM);
    if (!begins_as_playlist(*file)) return self.open_by_name_(format, opened, url, flags, options);
    if (++self.playlists_ >= most_playlists) return AVERROR(EPERM);
    try {
        auto text = text_of(*file);
        if (!text) return AVERROR(EPERM);
        self.texts_.push_back(std::make_unique<Text>(std::move(*text)));
    } catch (const Error&) {
        return AVERROR(ENOMEM);
    }
    *opened = self.texts_.back()->context();
    return 0;
}

int PlaylistFiles::close(AVFormatContext* format, AVIOContext* opened) {
    auto& texts = static_cast<PlaylistFiles*>(format->opaque)->texts_;
    const auto text = std::ranges::find(texts, opened, &Text::context);
    if (text == texts.end()) return avio_close(opened);
    if (text != texts.begin()) texts.erase(text);
    return 0;
}

}  // namespace vvr
