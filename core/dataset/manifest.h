#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/plane.h"
#include "core/condition/condition.h"
#include "core/media/frame_source.h"
#include "core/media/frame_span.h"

namespace vvr::dataset {

/// A frame in a folder of data files.
struct StoredFrame {
    std::int64_t index = 0;                               ///< in the clip
    double pts = 0;                                       ///< seconds from the clip's first frame
    std::optional<std::int64_t> seeds;                    ///< number of seeds; none = no flow and no seeds
    std::int64_t view = 0;                                ///< as `fields::Field::view`
    condition::Kind before = condition::Kind::no_signal;  ///< as `fields::Field::before`
    std::int64_t gap = 0;  ///< frames that a recording lacks between the one before and this one

    friend bool operator==(const StoredFrame&, const StoredFrame&) = default;
};

/// The manifest of a folder of data files (`manifest.json`, in docs/formats.md).
struct Manifest {
    media::VideoInfo clip;  ///< the whole clip, even if only a part is stored; `name` is only its title
    media::FrameSpan span;  ///< the requested part
    Size field_size;
    std::int64_t flow_every = 1;
    std::int64_t damaged = 0;  ///< packets in or next to these frames that did not decode
    bool colour = false;       ///< whether every frame's picture is stored
    bool reference = false;    ///< whether there was a reference (the empty scene)
    std::int64_t views = 0;    ///< number of further ones, of the camera's other views
    std::vector<std::pair<std::string, std::string>> settings;  ///< options by long name, as text
    std::vector<StoredFrame> frames;                            ///< consecutive, except for the gaps
};

/// Names of the files in the folder.
namespace stored {
inline constexpr const char* manifest = "manifest.json";
inline constexpr const char* scalar = "scalar";
inline constexpr const char* flow = "flow";
inline constexpr const char* seeds = "seeds";
inline constexpr const char* colour = "color";
inline constexpr const char* reference = "reference.png";
inline constexpr const char* views = "views";
inline constexpr const char* first = "first.png";
inline constexpr const char* last = "last.png";

std::filesystem::path scalar_file(std::int64_t index);
std::filesystem::path view_file(std::int64_t view);  ///< its empty scene; from 1
std::filesystem::path flow_file(std::int64_t index);
std::filesystem::path colour_file(std::int64_t index);
std::filesystem::path seed_file(std::int64_t index);
}  // namespace stored

/// The text of a manifest file.
std::string format_manifest(const Manifest& manifest);

/// The text of the manifest file until all other files are written.
std::string unfinished_manifest();

/// Parses a manifest file.
/// \param name name of the file, for messages
/// \throws Error io if it isn't a manifest, isn't finished or is invalid; not_video if it has no frames
Manifest parse_manifest(std::string_view text, const std::string& name);

/// Whether `folder` has a manifest of vvr, finished or not, or one that isn't JSON, which `parse_manifest` reports.
/// Manifests of other programs don't count.
bool is_data_folder(const std::filesystem::path& folder);

/// Whether the content of `folder` may be replaced: it has a readable manifest of vvr.
bool is_replaceable(const std::filesystem::path& folder);

/// Whether `folder` has a manifest of vvr that is not marked as unfinished.
bool has_complete_data(const std::filesystem::path& folder);

}  // namespace vvr::dataset
