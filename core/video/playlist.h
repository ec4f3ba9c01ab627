#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/video/av.h"

namespace vvr {

/// Whether a file is to be read as a playlist (HLS): only its name says so, never its contents.
bool is_playlist_name(const std::string& name);

/// Whether files of a format name other files.
bool is_playlist_format(const AVInputFormat& format);

/// libav's names of all containers, as its `format_whitelist` wants them. Playlists are left out unless `playlists`:
/// a file that names other files is not a clip, whatever its name says.
std::string allowed_formats(bool playlists);

/// What libav may open on behalf of a local playlist: regular files in the playlist's folder or below it.
///
/// A local playlist is complete as it is, so each is given an end: libav would wait for more of one that was cut off.
/// The number of playlists that one names is limited, as one may name itself.
class PlaylistFiles {
  public:
    /// \throws Error io when it can't be read, limit when it is too large to be a playlist
    explicit PlaylistFiles(const std::filesystem::path& playlist);
    ~PlaylistFiles();
    PlaylistFiles(const PlaylistFiles&) = delete;
    PlaylistFiles& operator=(const PlaylistFiles&) = delete;

    /// Makes `format` read this playlist, and open what it names through this object, which has to outlive it.
    void attach(AVFormatContext& format);

  private:
    class Text;

    static int open(AVFormatContext* format, AVIOContext** opened, const char* url, int flags, AVDictionary** options);
    static int close(AVFormatContext* format, AVIOContext* opened);
    bool may_open(const std::filesystem::path& file) const;

    using Open = int (*)(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**);
    Open open_by_name_ = nullptr;  ///< libav's own
    std::filesystem::path folder_;
    std::vector<std::unique_ptr<Text>> texts_;  ///< the first is that of the playlist itself
    int playlists_ = 0;
};

}  // namespace vvr
