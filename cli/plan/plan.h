#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/plan/look.h"
#include "cli/plan/options.h"
#include "core/annotation/ruler.h"
#include "core/annotation/sheet.h"
#include "core/detector/detector.h"
#include "core/fields/filter.h"
#include "core/fields/reference.h"
#include "core/footage/unseen.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

// The plan of a run: all that is decided before the first frame is read. Each verb gets the slice that it needs. No
// slice has a setting that another one changes; all names are resolved.
namespace vvr::app {

/// What is known about a clip, or its extracted fields, before the first frame is read.
struct ClipFacts {
    media::VideoInfo info{};
    Size field_size{};
    std::int64_t expected_frames = 0;     ///< 0 = unknown
    image::Metadata extracted{};          ///< settings fixed by an extraction; empty for a clip
    std::vector<std::string> warnings{};  ///< about the input, one sentence each
    media::FrameSpan span{};              ///< in seconds of the clip
};

/// The footage.
struct ReadPlan {
    InputOptions input{};
    ClipFacts clip{};
    media::FrameSpan span{};  ///< as the user gave it for an extraction; else that of the clip
    int threads = 0;          ///< 0 = one per core
    std::string camera{};     ///< empty = unknown
    WallClock clock{};        ///< for the ruler
    bool wants_clock = true;  ///< false if the user wants times to count from 0:00
};

/// What becomes of each frame, and what is looked for in it.
struct FieldPlan {
    const fields::FilterRow* filter = nullptr;
    const fields::ReferenceRow* reference = nullptr;  ///< null if the reference is a picture file
    bool flow = false;                                ///< of whole frames
    bool seeds = false;
    bool has_roi = false;
    bool has_region = false;                         ///< a region of interest or a mask
    std::vector<footage::Unseen::Area> areas{};      ///< that are left out of the scene
    std::optional<double> masked = 0;                ///< their share of the scene; none = unknown
    std::shared_ptr<detector::Detector> detector{};  ///< null = none
    tracking::EventChoice events{};                  ///< which events count
    bool finds_objects = false;                      ///< objects are tracked
    bool lists_events = false;                       ///< a report or a page lists the events
    bool keeps_portraits = false;                    ///< a picture or a page shows a still of each event
    bool keeps_boxes = false;                        ///< of the objects in each frame
    bool keeps_stills = false;                       ///< a picture shows frames of the moments that tell most
    bool keeps_frames = false;                       ///< frames are shown inside the volume
    bool keeps_moments = false;                      ///< a page or a still shows frames of all times
};

/// The amount of work, if the header's number of frames is correct.
struct Extent {
    std::int64_t frames = 0;  ///< 0 = unknown
    std::int64_t step = 1;    ///< frames per layer
    std::int64_t layers = 0;
    std::int64_t bricks = 0;
    std::int64_t bytes = 0;  ///< estimate of the peak memory, when no voxel is empty
};

/// The window that slides over a clip (§7): k bricks with the same number of layers.
struct SlidingWindow {
    int bricks = 8;  ///< k
    std::int64_t brick_layers = 1;
    std::int64_t step = 1;                   ///< frames per layer
    std::vector<std::int64_t> key_layers{};  ///< layers of a brick that begin with a key frame

    std::int64_t layers() const { return bricks * brick_layers; }
    std::int64_t brick_frames() const { return brick_layers * step; }
    std::int64_t frames() const { return layers() * step; }
    std::int64_t pieces_of_brick() const;  ///< the clip's last brick may have fewer
};

/// Layers and bricks, and what a voxel stores.
struct VolumePlan {
    BrickOptions bricks{};
    Extent extent{};
    bool series = false;                            ///< one picture per brick, while the window moves over the clip
    SlidingWindow window{};                         ///< for a series
    bool nonuniform = false;                        ///< layers have unequal lengths: more room where something moves
    bool drawn_again = false;                       ///< pieces are drawn more than once
    int keyframes = 0;                              ///< frames shown between the first and the last
    std::optional<fields::SeedFlags> seed_flags{};  ///< one per brick; none = those of the seeds
    const ColourRow* colour = nullptr;
    scene::TransferFunction second_transfer =
        scene::default_transfer_function();  ///< with the colours for the second filter's values
    scene::Theme theme{};                    ///< its colours of the flow
    glm::vec2 speed_range{};                 ///< of the flow's colours, pixels per frame

    bool colours_objects() const { return colour->drawn == gl::VolumeColour::object; }

    /// The number of textures for pieces of bricks. A single picture draws each piece once, so two are enough: one is
    /// filled while the other is drawn.
    int textures(int pieces) const;
};

/// Around the volume, in the part of a picture that a sheet leaves to it: the sheet already has a margin.
inline constexpr double sheet_margin = 0.01;

/// The positions of the volume and of the text around it in a picture.
struct Framing {
    annotation::Sheet sheet;
    space::Camera camera;       ///< for the whole picture
    annotation::TimeEdge edge;  ///< along which the ruler runs
    double half_pixel = 0;      ///< half the diagonal of the largest pixel that shows the volume, in P-space units
};

/// How it is drawn.
struct LookPlan {
    Parts show{};
    bool stills = false;      ///< there are frames between the first and the last
    bool only_page = false;   ///< the picture is only shown in a page, which writes the text over it
    bool pixel_data = false;  ///< pictures have the frame, time and depth of each pixel
    scene::Theme theme{};
    scene::TransferFunction transfer = scene::default_transfer_function();        ///< of the filter's values
    scene::TransferFunction drawn_transfer = scene::default_transfer_function();  ///< including the opacity
    Choice<space::LayoutRow> shape = space::layouts().front();
    std::shared_ptr<const space::Layout> layout{};
    Size field{};  ///< size of the fields
    scene::GlyphOptions glyphs{};
    scene::TraceOptions traces{};
    gl::RenderOptions picture{};  ///< framing() makes its camera
    std::string title{};
    BackendOptions backend{};

    /// Whether the picture has a part. A page has some beside its picture.
    bool shows(Part part) const {
        const bool elsewhere = only_page && parts()[static_cast<std::size_t>(part)].page_has_own;
        return show.has(part) && !elsewhere;
    }
    Framing framing() const;
};

/// What a page says beside its picture, and what it links to.
struct PagePlan {
    std::filesystem::path path{};    ///< where it is in the end; links are relative to it. Empty = no page
    std::filesystem::path index{};   ///< of the archive that has the page; empty = none
    std::filesystem::path pieces{};  ///< the final folder of the pieces of its events; empty = none
    std::string camera{};            ///< as the user or the archive names it; empty = from the names of files
    std::string heading{};           ///< before the time; empty = the camera, or the name
    std::string file{};              ///< display name of the input: a file name, or how many files there are
    bool is_titled = false;          ///< by the user
    bool plays_file = false;         ///< the input is one file
    bool turns = false;              ///< the page has the volume, so that its picture turns
    std::string file_ending{};       ///< for pieces cut from the clip; empty = unknown
};

/// What is made of it.
struct OutputPlan {
    OutputOptions files{};
    int pictures = 1;            ///< per brick in a series; 0 = none
    image::Metadata settings{};  ///< the record of all settings
};

/// The slice for observing.
struct ObservePlan {
    ReadPlan read{};
    FieldPlan field{};
    VolumePlan volume{};
};

/// The slice for composing. It names no output.
struct ComposePlan : ObservePlan {
    LookPlan look{};
    PagePlan page{};
};

struct Plan : ComposePlan {
    OutputPlan output{};
};

/// Frames per layer, from the header's length of the clip; 0 = unknown.
std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames);

}  // namespace vvr::app
