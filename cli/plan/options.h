#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/plan/look.h"
#include "core/annotation/time_ticks.h"
#include "core/detector/detector.h"
#include "core/fields/options.h"
#include "core/image/comparison.h"
#include "core/image/name_pattern.h"
#include "core/image/picture.h"
#include "core/media/frame_source.h"
#include "core/scene/flow_geometry.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"
#include "core/space/layout.h"
#include "core/tracking/event.h"
#include "gl/context.h"
#include "gl/render_options.h"

namespace vvr::app {

/// A time in a clip, or a length.
struct Time {
    enum class Unit { frames, seconds };
    double value = 0;
    Unit unit = Unit::frames;

    friend bool operator==(const Time&, const Time&) = default;
};

/// How the time of a clip is distributed along the arc.
enum class TimeScale { automatic, even, busy };

struct TimeScaleRow {
    TimeScale scale;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array time_scales{
    TimeScaleRow{TimeScale::automatic, "auto", "busy if the clip's header states more than two minutes, else even"},
    TimeScaleRow{TimeScale::even, "even", "the same room for all times"},
    TimeScaleRow{TimeScale::busy, "busy", "more room for times with motion; the ruler marks compressed times"},
};

/// The allowed difference of two pictures, and the output for a picture of the difference.
struct ComparisonOptions {
    image::Tolerance tolerance;
    std::filesystem::path diff;  ///< empty = none
};

/// The reference of a picture.
struct GoldenOptions {
    std::filesystem::path path;                                ///< empty = none
    bool bless = false;                                        ///< replace the golden picture
    std::function<void(const image::Comparison&)> compared{};  ///< called with the result of a comparison
    ComparisonOptions comparison;
};

/// Where pictures and the files about them go.
struct OutputOptions {
    std::filesystem::path path;
    std::filesystem::path page;        ///< in addition to the picture; empty = none, unless `path` is a page
    std::string page_camera;           ///< shown on the page; empty = from the file name
    std::string page_heading;          ///< at the top of the page, before the time; empty = the camera, or the name
    std::filesystem::path page_index;  ///< of the archive that has the page; empty = none
    std::filesystem::path page_place;  ///< final path of the page, for links; empty = where it is written
    bool flat_page = false;            ///< the page's picture does not turn
    std::filesystem::path thumbnail;   ///< empty = none
    std::filesystem::path still;       ///< for a frame of the clip; empty = none
    std::filesystem::path stills;      ///< for the contact sheet of the events; empty = none
    /// Pieces of the clip with its events, beside a page.
    struct Pieces {
        std::filesystem::path folder;  ///< where they are written; empty = none
        std::filesystem::path place;   ///< their final folder, for links
        double margin = 0;             ///< seconds before and after an event
    };
    Pieces pieces{};
    bool plain_name = false;           ///< `path` contains no pattern field
    std::optional<int> animate;        ///< number of pictures with moving texture
    std::optional<int> slide;          ///< film of the sliding window: pictures per brick
    std::filesystem::path report;      ///< empty = none
    std::filesystem::path events_csv;  ///< the events as a table; empty = none
    std::filesystem::path tracks;      ///< the objects' boxes in each frame; empty = none
    bool reports_events = false;       ///< of a stream: each event is reported when it has ended
    bool returns_events = false;       ///< the caller gets the events
    bool returns_pixel_data = false;   ///< the caller gets the frame, time and depth of each pixel
    tracking::EventChoice events;      ///< which events are listed
    GoldenOptions golden;

    /// Whether somebody gets a list of the events; it needs no picture.
    bool lists_events() const { return returns_events || !report.empty() || !events_csv.empty() || !tracks.empty(); }
};

/// Default number of pictures of an animation.
inline constexpr int default_animation = 24;

/// The pattern for the output's file names.
/// \throws Error usage
image::NamePattern name_of(const OutputOptions& options);

/// Whether the window slides over the clip: for one picture per brick, or a film.
bool is_series(const OutputOptions& options);

/// Whether the extension is that of a page.
bool is_page(const std::filesystem::path& path);

/// The page's path: the output itself, or --page; empty = no page.
const std::filesystem::path& page_of(const OutputOptions& options);

/// The number of pictures; of a film, the number per brick. 0 if only a report is wanted.
int pictures_of(const OutputOptions& options);

/// The input. FieldOptions::span selects its frames.
struct InputOptions {
    std::vector<std::string> names;  ///< a clip, the files of a recording, or the folders of an extraction in parts
    std::vector<std::string> name_patterns;  ///< of file names; tried before those of known recorders
    bool join = false;                       ///< treat files as one recording even if they look unrelated
    Size field_size{0, 0};                   ///< as in SourceOptions
    Choice<media::FrameChoiceRow> decode{media::frame_choices().front()};
    Choice<media::HwaccelRow> hwaccel{media::hwaccels().front()};
    double rate = 0;                                                                         ///< as in SourceOptions
    int track = 0;                                                                           ///< as in SourceOptions
    std::optional<media::Aspect> aspect{};                                                   ///< as in SourceOptions
    std::function<std::unique_ptr<media::FrameSource>(const media::SourceOptions&)> open{};  ///< replaces the files
    std::string camera{};                 ///< named by the user; empty = from the names of files and folders
    std::vector<std::string> problems{};  ///< known before the files are read, one sentence each
};

/// How time becomes layers and bricks.
struct BrickOptions {
    std::int64_t max_layers = 800;  ///< in the window; in longer clips several frames share a layer
    int step = 0;                   ///< frames per layer; 0 = the minimum that max_layers allows
    int window = 8;                 ///< bricks in the window; without `length`, the clip is divided into as many
    std::optional<Time> length{};   ///< of a brick
    TimeScale time = TimeScale::automatic;
};

/// The time at which a clip began.
struct StartTime {
    enum class From {
        automatic,  ///< from the clip's name, if it has one
        recorded,   ///< from the clip's name; an error if it has none
        container,  ///< the creation time in the container
        modified,   ///< the file's modification time minus the clip's length
        given,
        none,
    };
    From from = From::automatic;
    WallClock clock{};  ///< for From::given
};

/// A transfer function, and the name or the file that it has.
struct NamedTransfer {
    std::string name;
    scene::TransferFunction function;
};

/// What the picture shows of the volume and the flow. RenderOptions has how it is drawn.
struct LookOptions {
    Parts show = Parts::by_default();
    int keyframes = 0;  ///< frames shown between the first and the last
    scene::Theme theme = scene::themes().front();
    std::optional<glm::vec4> background{};    ///< premultiplied; none = the theme's
    std::optional<NamedTransfer> transfer{};  ///< none = the theme's
    Choice<ColourRow> colour = "auto";
    std::string title;  ///< empty = the clip's name
    StartTime start_time;
    double opacity = 1;      ///< factor for the extinction
    double glyph_scale = 1;  ///< factor for the arrows' size
    scene::TraceOptions traces;
};

/// The object detector that looks at events.
struct DetectorOptions {
    std::filesystem::path model;  ///< empty = none
    detector::Trial trial = detector::Trial::in_child;
};

/// The OpenGL to draw with.
struct BackendOptions {
    Choice<gl::Backend> row = "auto";
    int device = -1;     ///< EGL device number; -1 = the first that works
    bool debug = false;  ///< log the driver's messages as warnings
};

}  // namespace vvr::app
