#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/events/event.h"
#include "core/image/picture.h"
#include "core/page/watched_fields.h"

namespace vvr {

/// What stands in a page.
struct PageContent {
    std::string name;      ///< of the clip, as people are to read it
    std::string clip_url;  ///< where it is from the page; empty = there is no file to play
    Size shown;            ///< size of the clip's picture
    Size field;            ///< in whose pixels the events are
    Picture picture;       ///< with its layers
    Metadata settings;     ///< that made it
    Moments moments;
    std::optional<std::vector<Event>> events;  ///< where they were looked for
};

/// A page that needs nothing but a browser, and no other file but the clip: the picture, the moments that each of its
/// pixels shows, stills and a preview to look at them. Same content, same text.
std::string make_page(const PageContent& content);

}  // namespace vvr
