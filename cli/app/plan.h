#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/app/colour.h"
#include "cli/app/framing.h"
#include "cli/app/input.h"
#include "cli/app/job.h"
#include "core/fields/filter.h"
#include "core/fields/reference.h"

// What is to be done: a job, checked against the footage that was opened for it.
namespace vvr::app {

/// What a run is for, beside what its output names.
enum class Purpose {
    files,   ///< those that its output names
    caller,  ///< who takes the pictures
    stream,  ///< a live one, of which there is a picture for each brick
    search,  ///< its events alone
};

/// What a run has to make, beside files.
struct Products {
    int pictures = 1;         ///< over which the texture of the tracelines moves on by one stripe
    bool series = false;      ///< a picture for each brick, while the window moves over the clip
    bool pixel_data = false;  ///< pictures come with the frame, time and depth that each pixel shows
    bool events = false;      ///< a report or a page tells of them
    bool portraits = false;   ///< a page shows a still of each event
};

/// How much there is to do, if the clip has as many frames as its header says.
struct Extent {
    std::int64_t frames = 0;  ///< 0 = unknown
    std::int64_t step = 1;    ///< frames per layer
    std::int64_t layers = 0;
    std::int64_t bricks = 0;
    std::int64_t bytes = 0;  ///< estimate of the most memory that it can take, with something everywhere
};

/// The window that slides over a clip (§7): k bricks of the same number of layers.
struct SlidingWindow {
    int bricks = 8;  ///< k
    std::int64_t brick_layers = 1;
    std::int64_t step = 1;                   ///< frames per layer
    std::vector<std::int64_t> key_layers{};  ///< of a brick, at whose beginnings key frames stand

    std::int64_t layers() const { return bricks * brick_layers; }
    std::int64_t brick_frames() const { return brick_layers * step; }
    std::int64_t frames() const { return layers() * step; }
    std::int64_t pieces_of_brick() const;  ///< fewer of the clip's last one, if it is shorter
};

/// What is to be done. Nothing in it changes while it is done, and nothing is looked up by name any more.
struct Plan {
    RenderJob job{};  ///< with what the footage and other settings have decided
    ClipFacts clip{};
    Products products{};
    Extent extent{};
    SlidingWindow window{};  ///< of a series
    const fields::FilterRow* filter = nullptr;
    const ColourRow* colour = nullptr;
    const fields::FilterRow* second = nullptr;        ///< whose values have the colours; null = none
    const fields::ReferenceRow* reference = nullptr;  ///< null where it is a picture file
    bool finds_objects = false;                       ///< the run follows them
    bool nonuniform = false;                          ///< room along the arc goes where something moves
    scene::TransferFunction transfer;                 ///< of the filter's values
    scene::TransferFunction drawn_transfer;           ///< with the opacity
    scene::TransferFunction second_transfer;          ///< whose colours the second filter's values have
    std::shared_ptr<const space::Layout> layout{};
    scene::GlyphOptions glyphs{};
    gl::RenderOptions picture{};  ///< but for the camera
    std::string title{};
    WallClock clock{};  ///< that the ruler shows

    bool shows(Part part) const { return job.look.show.has(part); }
    bool colours_objects() const { return colour->drawn == gl::VolumeColour::object; }
    Framing framing() const { return frame_volume(job, *layout, clip.field_size); }
};

/// The only way to a plan, for all commands.
/// \param job that is valid
/// \throws Error usage for a colour that is in no table, objects in colours where the filter marks none, colours that
///         need flow where there is none, and bricks or a clock that the clip doesn't tell
Plan make_plan(RenderJob job, ClipFacts clip, Purpose purpose = Purpose::files);

/// The frames that each layer takes, from what the container says of the clip's length; 0 = unknown.
std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames);

/// The textures that there are at a time for pieces of bricks. In a single picture each piece is drawn but once: one
/// texture is filled while another is drawn.
int textures_of(const Products& products, int pieces);

/// \throws Error limit when the machine has less memory than that, where the system would kill the program half way
void check_memory(const Extent& extent);

}  // namespace vvr::app
