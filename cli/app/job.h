#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/app/colour.h"
#include "cli/app/part.h"
#include "core/events/event.h"
#include "core/fields/options.h"
#include "core/image/comparison.h"
#include "core/image/name_pattern.h"
#include "core/image/picture.h"
#include "core/labels/time_ticks.h"
#include "core/scene/flow_geometry.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"
#include "core/space/layout.h"
#include "core/video/frame_source.h"
#include "gl/backend.h"
#include "gl/render_options.h"

namespace vvr::app {

/// A place in a clip, or a length of it.
struct Time {
    enum class Unit { frames, seconds };
    double value = 0;
    Unit unit = Unit::frames;

    friend bool operator==(const Time&, const Time&) = default;
};

/// How the room along the arc is given to the time of a clip.
enum class TimeScale { automatic, even, busy };

struct TimeScaleRow {
    TimeScale scale;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array time_scales{
    TimeScaleRow{TimeScale::automatic, "auto", "busy where the header says more than two minutes, else even"},
    TimeScaleRow{TimeScale::even, "even", "all time has the same room"},
    TimeScaleRow{TimeScale::busy, "busy", "room goes where something moves; the ruler marks where time is squeezed"},
};

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

/// What is read. Which frames of it FieldOptions::span says.
struct InputOptions {
    std::vector<std::string> names;  ///< a clip, the files of a recording, or the folders of an extraction in parts
    std::vector<std::string> name_patterns;  ///< of files' names, before those of known recorders
    bool join = false;                       ///< files that seem to be unrelated are one recording all the same
    Size field_size{0, 0};                   ///< as in SourceOptions
    double rate = 25;                        ///< frames per second, where the input does not say
};

/// How time becomes layers and bricks.
struct BrickOptions {
    std::int64_t max_layers = 800;  ///< of the window; frames of a longer clip share layers
    int step = 0;                   ///< frames per layer; 0 = as few as max_layers allows
    int window = 8;                 ///< bricks of the window; without `length`, a clip is cut into as many
    std::optional<Time> length{};   ///< of a brick
    TimeScale time = TimeScale::automatic;
};

/// When a clip began.
struct StartTime {
    enum class From {
        automatic,  ///< its name, where it tells
        recorded,   ///< the same, and it is an error where it doesn't
        container,  ///< when the container says it was written
        modified,   ///< when the file was last written, less its length
        given,
        none,
    };
    From from = From::automatic;
    WallClock clock{};  ///< that was given
};

/// What the picture shows of the volume and the flow. How it draws that RenderOptions says.
struct LookOptions {
    Parts show = Parts::by_default();
    int keyframes = 0;  ///< frames shown between the first and the last
    scene::Theme theme = scene::themes().front();
    std::optional<glm::vec4> background{};              ///< multiplied by its opacity; none = the theme's
    std::optional<scene::TransferFunction> transfer{};  ///< none = the theme's
    Choice<ColourRow> colour = "auto";
    std::string title;           ///< empty = the clip's name
    std::filesystem::path font;  ///< of all text; empty = fontconfig's sans
    StartTime start_time;
    double opacity = 1;                            ///< factor on the extinction
    double glyph_scale = 1;                        ///< factor on the arrows' size
    double glyph_cap = scene::GlyphOptions{}.cap;  ///< of arrows at factor 1
    scene::TraceOptions traces;
    std::optional<space::View> slice_view{};  ///< whose slices Part::slices shows; none = the picture's own view
};

/// Which OpenGL draws.
struct BackendOptions {
    Choice<gl::Backend> row = "auto";
    int device = -1;     ///< EGL's number; -1 = the first that works
    bool debug = false;  ///< what the driver says is a warning
};

/// A whole run: what is read, what is computed, how it is drawn, and where it goes.
struct RenderJob {
    InputOptions input;
    fields::FieldOptions fields;
    std::string seeds;  ///< lists that replace the computed seeds, as ListedSeeds; empty = none
    std::optional<fields::SeedFlags> seed_flags{};  ///< of the bricks; none = the seeds' own
    BrickOptions bricks;
    Choice<space::LayoutRow> layout = space::layouts().front();
    space::LayoutOptions shape;
    LookOptions look;
    gl::RenderOptions picture;  ///< camera, background and glyphs are made of the rest
    BackendOptions backend;
    OutputOptions output;
    image::Metadata settings;  ///< all settings as texts, in the order in which files and reports record them
    image::Metadata given;     ///< those that were asked for; they must not contradict an extraction
};

/// \throws Error usage for a value that is out of its range, or values that contradict each other
void validate(const RenderJob& job);
void validate(const space::LayoutOptions& shape);

/// \throws Error usage for what only one picture of a whole clip can have
void validate_series(const RenderJob& job);

/// The clock that a clip's ruler shows.
/// \throws Error usage where what is to say when it was recorded does not
WallClock clock_of(const StartTime& start, const video::VideoInfo& info);

}  // namespace vvr::app
