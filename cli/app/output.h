#pragma once

#include <filesystem>
#include <optional>

#include "core/events/event_choice.h"
#include "core/image/compare.h"
#include "core/image/name_pattern.h"

namespace vvr::app {

/// By how much two pictures may differ, and where a picture of the differences goes.
struct ComparisonOptions {
    image::Tolerance tolerance;
    std::filesystem::path diff;  ///< empty = nowhere
};

/// What a picture is compared with.
struct GoldenOptions {
    std::filesystem::path path;  ///< empty = nothing
    bool bless = false;          ///< the picture replaces the golden one instead
    ComparisonOptions comparison;
};

/// Where pictures go, and what is written about them.
struct OutputOptions {
    std::filesystem::path path;
    std::filesystem::path page;        ///< beside the picture; empty = none, unless `path` is one
    std::string page_camera;           ///< that the page names; empty = what names of files tell
    std::filesystem::path page_index;  ///< of the archive that the page belongs to; empty = none
    std::filesystem::path page_place;  ///< where the page will stand; empty = where it is written
    std::filesystem::path thumbnail;   ///< empty = none
    std::filesystem::path still;       ///< a frame of the clip; empty = none
    bool plain_name = false;           ///< nothing in `path` is a field
    std::optional<int> animate;        ///< pictures of the moving texture
    std::optional<int> slide;          ///< a film of the window that slides over the clip: pictures per brick
    std::filesystem::path report;      ///< empty = nowhere
    events::EventChoice events;        ///< which of them the report and the page list
    GoldenOptions golden;
};

/// Pictures of an animation if nothing says how many.
inline constexpr int default_animation = 24;

/// The names of the files that the output goes to.
/// \throws Error usage
image::NamePattern name_of(const OutputOptions& options);

/// Whether a window slides over the clip: a picture for each brick, or a film of them.
bool is_series(const OutputOptions& options);

/// Whether a file of that name is a page.
bool is_page(const std::filesystem::path& path);

/// Where a page goes: to the output itself or beside it; empty = nowhere.
const std::filesystem::path& page_of(const OutputOptions& options);

/// The number of pictures that the options ask for, of a film per brick: none where only a report is wanted.
int pictures_of(const OutputOptions& options);

}  // namespace vvr::app
