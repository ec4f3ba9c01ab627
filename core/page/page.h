#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/events/event.h"
#include "core/image/picture.h"
#include "core/page/watched_fields.h"
#include "core/wall_clock.h"

namespace vvr {

/// What a page shows.
struct PageContent {
    std::string name;      ///< of the clip, for people
    std::string clip_url;  ///< of the clip, relative to the page; empty = there is no file to play

    /// A file of a recording.
    struct Segment {
        std::string url;   ///< relative to the page
        double begin = 0;  ///< seconds of the recording
        double length = 0;
    };
    std::vector<Segment> segments;  ///< instead of a clip, in order
    WallClock clock;                ///< that the picture shows
    Size shown;                     ///< size of the clip's picture
    Size field;                     ///< size of the field, whose pixels are the unit of events
    Picture picture;                ///< with its pixel data
    Metadata settings;              ///< of the picture
    Moments moments;
    std::optional<std::vector<Event>> events;  ///< if they were searched for
    std::vector<glm::vec3> colours;            ///< of the events in the picture, sRGB; empty where they have none

    /// A part of the picture that stands for an event.
    struct Region {
        PixelBox box;
        std::size_t number = 0;  ///< of the event: its place in the list, plus 1
    };
    std::vector<Region> regions;
};

/// A page that needs only a browser, and no file but the clip: the picture, the moment that each of its pixels shows,
/// and stills and a preview of these moments. Same content, same text.
std::string make_page(const PageContent& content);

}  // namespace vvr
