#pragma once

#include <bitset>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/setting.h"
#include "core/fields/options.h"
#include "gl/render_options.h"

namespace vvr::app {

/// The parts of a picture.
enum class Part {
    volume,
    portraits,
    map,
    strip,
    numbers,
    directions,
    arrows,
    tracelines,
    outline,
    ribs,
    frames,
    ends,
    floor,
    ruler,
    legend,
    title,
    explanation,
    bricks,
    boxes,
    slices
};

/// A row of the table of parts.
struct PartRow {
    Part part;
    std::string_view name;
    std::string_view help;
    bool by_default = false;
    bool needs_seeds = false;     ///< needs seeds
    bool needs_flow = false;      ///< needs the flow of whole frames
    bool needs_pictures = false;  ///< needs frames in colour
    bool needs_events = false;    ///< needs objects, and so a filter that marks them
    bool around_volume = false;   ///< extends beyond the outline of the volume
    bool page_has_own = false;    ///< a page shows it beside its picture
};

/// All parts, in the order of the enum.
std::span<const PartRow> parts();

/// A set of parts.
class Parts {
  public:
    Parts() = default;
    Parts(std::initializer_list<Part> parts) {
        for (const Part part : parts) add(part);
    }

    /// The parts that a picture shows by default.
    static Parts by_default();

    void add(Part part) { set_.set(static_cast<std::size_t>(part)); }
    void remove(Part part) { set_.reset(static_cast<std::size_t>(part)); }
    bool has(Part part) const { return set_.test(static_cast<std::size_t>(part)); }

    /// Whether any part has a trait: `any(&PartRow::needs_flow)`.
    bool any(bool PartRow::*trait) const;

    friend bool operator==(const Parts&, const Parts&) = default;

  private:
    std::bitset<32> set_;
};

/// A row of the table of colours: the source of the volume's colours. The opacity always comes from the transfer
/// function of the filter's values.
struct ColourRow {
    std::string name;
    std::string help;
    gl::VolumeColour drawn = gl::VolumeColour::transfer;
    bool needs_pictures = false;
    bool needs_flow = false;                    ///< of each frame
    bool of_direction = false;                  ///< the colour shows the flow's direction, not its speed
    const fields::FilterRow* filter = nullptr;  ///< a second filter that provides the values to colour; null = none
};

/// The rows of the table. The first one leaves the choice to vvr.
const std::vector<ColourRow>& colour_rows();

const ColourRow& row_of(Name<ColourRow> name);

}  // namespace vvr::app
