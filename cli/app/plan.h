#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/app/input.h"
#include "cli/app/job.h"
#include "cli/app/look.h"
#include "core/annotation/ruler.h"
#include "core/annotation/sheet.h"
#include "core/detector/detector.h"
#include "core/fields/filter.h"
#include "core/fields/reference.h"
#include "core/footage/unseen.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

// The plan of a run: a job that was checked against the opened footage.
namespace vvr::app {

/// The positions of the volume and of the text around it in a picture.
struct Framing {
    annotation::Sheet sheet;
    space::Camera camera;       ///< for the whole picture
    annotation::TimeEdge edge;  ///< along which the ruler runs
    double half_pixel = 0;      ///< half the diagonal of the largest pixel that shows the volume, in P-space units
};

/// The purpose of a run, beyond the files named by its output.
enum class Purpose {
    files,   ///< the files named by its output
    caller,  ///< the caller takes the pictures
    stream,  ///< a live stream; one picture per brick
    search,  ///< only the events
};

/// The products of a run in addition to files.
struct Products {
    int pictures = 1;         ///< number of pictures, per brick in a series; 0 = none
    bool series = false;      ///< one picture per brick, while the window moves over the clip
    bool pixel_data = false;  ///< pictures have the frame, time and depth of each pixel
    bool events = false;      ///< a report or a page lists the events
    bool portraits = false;   ///< a page shows a still of each event
    bool only_page = false;   ///< the picture is only shown in a page, which writes the text over it
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

/// All decisions about a run. Immutable during the run; all names are resolved.
struct Plan {
    RenderJob job{};  ///< with the values that depend on footage and other settings
    ClipFacts clip{};
    Products products{};
    Extent extent{};
    SlidingWindow window{};  ///< for a series
    const fields::FilterRow* filter = nullptr;
    const ColourRow* colour = nullptr;
    const fields::FilterRow* second = nullptr;        ///< the filter whose values are coloured; null = none
    const fields::ReferenceRow* reference = nullptr;  ///< null if the reference is a picture file
    std::shared_ptr<detector::Detector> detector{};   ///< null = none
    bool finds_objects = false;                       ///< the run tracks objects
    bool nonuniform = false;                          ///< layers have unequal lengths: more room where something moves
    scene::TransferFunction transfer;                 ///< of the filter's values
    scene::TransferFunction drawn_transfer;           ///< including the opacity
    scene::TransferFunction second_transfer;          ///< with the colours for the second filter's values
    std::shared_ptr<const space::Layout> layout{};
    scene::GlyphOptions glyphs{};
    gl::RenderOptions picture{};  ///< without the camera
    std::string title{};
    WallClock clock{};                           ///< for the ruler
    std::vector<footage::Unseen::Area> areas{};  ///< that are left out of the scene
    std::optional<double> masked = 0;            ///< their share of the scene; none = unknown

    /// Whether the picture has a part. A page has some beside its picture.
    bool shows(Part part) const {
        const bool elsewhere = products.only_page && parts()[static_cast<std::size_t>(part)].page_has_own;
        return job.look.show.has(part) && !elsewhere;
    }
    bool colours_objects() const { return colour->drawn == gl::VolumeColour::object; }
    Framing framing() const;
};

/// Makes the plan, for all commands.
/// \param job valid, see validate()
/// \param detector from open_detector; null = none
/// \throws Error usage for an unknown colour, object colours when the filter marks no objects, flow colours without
/// flow, and bricks or a clock for which the clip lacks data
Plan make_plan(RenderJob job, ClipFacts clip, Purpose purpose = Purpose::files,
               std::shared_ptr<detector::Detector> detector = nullptr);

/// Frames per layer, from the header's length of the clip; 0 = unknown.
std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames);

/// The number of textures for pieces of bricks. A single picture draws each piece once, so two are enough: one is
/// filled while the other is drawn.
int textures_of(const Products& products, int pieces);

/// \throws Error limit when the machine has less memory than needed, as the system would otherwise kill the program
/// during the run
void check_memory(const Extent& extent);

}  // namespace vvr::app
