#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/footage/unseen.h"
#include "core/image/picture.h"
#include "core/media/frame_span.h"
#include "core/page/moments.h"
#include "core/tracking/event.h"

namespace vvr::page {

/// The state of a live stream, for its page.
struct LiveState {
    std::string text;           ///< state of the connection, one line
    std::int64_t written = 0;   ///< seconds since 1970
    std::int64_t dropped = 0;   ///< frames that came too fast
    double brick_seconds = 10;  ///< seconds per picture
};

/// A page's place in an archive.
struct PageIndex {
    std::string url;   ///< of the index, relative to the page
    std::string clip;  ///< the clip's path in the index
};

/// What a page draws over its picture, in pixels of the picture.
struct Overlay {
    /// A cross-section of the volume: the frame at one time.
    struct Section {
        double seconds = 0;                   ///< of the clip
        std::array<glm::dvec2, 4> corners{};  ///< of the frame: upper left, upper right, lower right, lower left
    };
    std::vector<Section> sections;  ///< in order of time

    /// A text beside the time axis.
    struct Note {
        std::string text;
        double t = 0;  ///< t_C
        glm::dvec2 at{};
        glm::dvec2 out{};  ///< unit vector away from the volume: the text is on that side
    };
    std::vector<Note> notes;  ///< the most important first

    /// An event's portrait, with a line to its trail.
    struct Portrait {
        std::size_t event = 0;  ///< index in the list of events
        PixelBox still;
        glm::dvec4 object{};  ///< left, top, right and bottom of the object, as shares of the still
        glm::dvec2 to{};
    };
    std::vector<Portrait> portraits;
    int captions = 0;      ///< height of the space above the portraits
    bool numbers = false;  ///< trails have numbers
    PixelBox map;          ///< empty = no map
    Plane<Bgr> scene{};    ///< of the map
};

/// The content of a page.
struct PageContent {
    std::string name;       ///< display name of the clip
    std::string camera;     ///< empty = unknown
    std::string heading{};  ///< before the time; empty = the camera, or the name
    std::string file;       ///< the clip's file name if it differs from `name` and `camera`; else empty
    std::string clip_url;   ///< relative to the page; empty = no file to play

    /// A file of a recording.
    struct Segment {
        std::string url;   ///< relative to the page
        double begin = 0;  ///< seconds of the recording
        double length = 0;
    };
    std::vector<Segment> segments;   ///< of a recording, in order, instead of a clip
    std::vector<Segment> pieces{};   ///< with the events, in order, for when the footage is gone
    std::vector<Segment> films{};    ///< of a stream's last bricks, in order
    double stretch = 1;              ///< seconds per second of the clock of these files
    std::string piece_extension;     ///< extension for parts cut from the clip; empty = `vvr cut` chooses
    std::vector<std::string> names;  ///< the user's patterns of file names
    WallClock clock;                 ///< wall clock of the picture
    Size shown;                      ///< display size of the clip
    Size field;                      ///< field size; events are in field pixels
    image::Picture picture;          ///< includes pixel data
    image::Metadata settings;        ///< of the picture
    Moments moments;
    media::FrameSpan span{};                             ///< the requested part of the clip
    std::vector<condition::Interval> missing{};          ///< in it
    std::optional<std::vector<tracking::Event>> events;  ///< none = not detected
    std::vector<std::size_t> numbers;                    ///< numbers of the events in the picture; empty = index plus 1
    std::vector<glm::vec3> colours;                      ///< of the events in the picture, sRGB; empty = no colours
    std::vector<Plane<Bgr>> portraits;                   ///< of the events; an empty plane = none
    std::size_t not_chosen = 0;                          ///< number of other events that were found
    std::vector<std::string> activities;                 ///< what each of them did: "went down and right"
    std::optional<PageIndex> index;
    std::optional<LiveState> live;  ///< of a stream
    footage::Unseen unseen{};
    Overlay overlay;
    Json turning{};  ///< the volume that turns, as the page's script reads it; null = the picture stays as it is

    /// The number that people see of the event at an index.
    std::size_t number_of(std::size_t k) const { return k < numbers.size() ? numbers[k] : k + 1; }

    ClockSource clock_source() const { return clock ? clock->source : ClockSource::none; }
};

// The data of a clip's page, in the order in which the page needs them.

/// What the page needs before anything can be done with it. The rest comes after its script.
nlohmann::ordered_json page_data(const PageContent& content);

/// The frame and the event that each pixel of the picture shows.
nlohmann::ordered_json pixel_data(const PageContent& content);

/// Stills of the clip and of its events.
nlohmann::ordered_json still_data(const PageContent& content);

/// The film in small, for clips that a browser can't play; null = there is none.
nlohmann::ordered_json preview_data(const PageContent& content);

}  // namespace vvr::page
