#pragma once

#include <string>

#include "core/base/plane.h"
#include "core/page/page_data.h"

namespace vvr::page {

/// Makes a self-contained HTML page: the picture, the time and event of each pixel, stills and a preview. It refers
/// only to the clip's file. The page of a stream requests updates from its server. The output is deterministic.
std::string make_page(const PageContent& content);

/// The last page of a stream that has ended.
std::string with_ended_stream(std::string page);

/// A stream's page with other words for what the stream does. They must need no escape in JSON.
std::string with_state(std::string page, const std::string& state);

/// The content of a page for drawing regions.
struct RegionEditorContent {
    std::string name;    ///< display name of the clip
    std::string moment;  ///< time of the frame, as text
    Plane<Bgr> frame;    ///< at the clip's display size; regions are in its pixels
    std::string roi;     ///< initial polygons, as in FieldOptions; empty = none
    std::string mask;    ///< initial polygons to exclude; edited only if `roi` is empty
};

/// Makes a self-contained HTML page where the user draws regions on the frame and copies the option for them. The
/// output is deterministic.
std::string make_region_editor(const RegionEditorContent& content);

}  // namespace vvr::page
