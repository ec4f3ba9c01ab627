#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/plane.h"
#include "core/video/frame_source.h"
#include "core/video/frame_span.h"

namespace vvr::store {

/// One frame of a directory of data files.
struct StoredFrame {
    std::int64_t index = 0;             ///< in the clip
    double pts = 0;                     ///< seconds from the clip's first frame
    std::optional<std::int64_t> seeds;  ///< how many its list holds; none = the frame has neither flow nor seeds

    friend bool operator==(const StoredFrame&, const StoredFrame&) = default;
};

/// What a directory of data files says of itself (`manifest.json`, in docs/formats.md).
struct Manifest {
    video::VideoInfo clip;  ///< of the whole clip, however little of it is here; of its name only the title
    video::FrameSpan span;  ///< that was asked for
    Size field_size;
    std::int64_t flow_every = 1;
    std::int64_t damaged = 0;  ///< packets that did not decode, of these frames and their neighbours
    bool colour = false;       ///< whether every frame's picture is here
    bool reference = false;    ///< whether there was an empty scene to compare with
    std::vector<std::pair<std::string, std::string>> settings;  ///< long names of options, and their texts
    std::vector<StoredFrame> frames;                            ///< one after the other, no gap
};

/// Names of the files inside the directory.
namespace stored {
inline constexpr const char* manifest = "manifest.json";
inline constexpr const char* scalar = "scalar";
inline constexpr const char* flow = "flow";
inline constexpr const char* seeds = "seeds";
inline constexpr const char* colour = "color";
inline constexpr const char* reference = "reference.png";
inline constexpr const char* first = "first.png";
inline constexpr const char* last = "last.png";

std::filesystem::path scalar_file(std::int64_t index);
std::filesystem::path flow_file(std::int64_t index);
std::filesystem::path colour_file(std::int64_t index);
std::filesystem::path seed_file(std::int64_t index);
}  // namespace stored

/// The text of the file.
std::string format_manifest(const Manifest& manifest);

/// The text that stands there until all else is written.
std::string unfinished_manifest();

/// \param name of the file, for the error text
/// \throws Error io for what isn't a manifest, isn't finished, or can't be true; not_video where there is no frame
Manifest parse_manifest(std::string_view text, const std::string& name);

/// Whether `folder` has a manifest of ours, finished or not; one that is not even JSON counts, so that its reader
/// says so. A manifest of some other program does not.
bool is_data_folder(const std::filesystem::path& folder);

/// Whether what is in `folder` is ours to replace: its manifest says so. One that can't be read says nothing.
bool is_replaceable(const std::filesystem::path& folder);

}  // namespace vvr::store
