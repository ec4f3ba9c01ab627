#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/events/event.h"
#include "core/image/picture.h"
#include "core/page/moments.h"

namespace vvr::page {

/// What the page of a stream says beside its picture.
struct LiveState {
    std::string text;           ///< of the connection, in a line for people
    std::int64_t written = 0;   ///< seconds since 1970
    double brick_seconds = 10;  ///< from one picture to the next
};

/// Where a page belongs in an archive.
struct PageIndex {
    std::string url;   ///< of the index, relative to the page
    std::string clip;  ///< the clip's path as the index writes it
};

/// What a page shows.
struct PageContent {
    std::string name;      ///< of the clip, for people
    std::string camera;    ///< empty = nothing tells it
    std::string file;      ///< the clip's own name, where `name` or `camera` is another; else empty
    std::string clip_url;  ///< of the clip, relative to the page; empty = there is no file to play

    /// A file of a recording.
    struct Segment {
        std::string url;   ///< relative to the page
        double begin = 0;  ///< seconds of the recording
        double length = 0;
    };
    std::vector<Segment> segments;   ///< instead of a clip, in order
    std::string piece_extension;     ///< of a file that can hold what is cut out of the clip; empty = `vvr cut` chooses
    std::vector<std::string> names;  ///< how files' names tell camera and time, as it was said
    WallClock clock;                 ///< that the picture shows
    Size shown;                      ///< size of the clip's picture
    Size field;                      ///< size of the field, whose pixels are the unit of events
    image::Picture picture;          ///< with its pixel data
    image::Metadata settings;        ///< of the picture
    Moments moments;
    std::optional<std::vector<events::Event>> events;  ///< if they were searched for
    std::vector<std::size_t> numbers;                  ///< of the events in the picture; empty = their places, plus 1
    std::vector<glm::vec3> colours;     ///< of the events in the picture, sRGB; empty where they have none
    std::vector<Plane<Bgr>> portraits;  ///< of the events; empty where there is none
    std::optional<PageIndex> index;
    std::optional<LiveState> live;  ///< of a stream

    /// A part of the picture that stands for an event.
    struct Region {
        PixelBox box;
        std::size_t number = 0;  ///< of the event
    };
    std::vector<Region> regions;
};

/// A page that needs only a browser, and no file but the clip: the picture, the moment and the event that each of its
/// pixels shows, and stills and a preview of these moments. The page of a stream asks its server for newer ones. Same
/// content, same text.
std::string make_page(const PageContent& content);

}  // namespace vvr::page
