#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

#include "core/fields/field.h"
#include "core/fields/frame_files.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/media/frame.h"

namespace vvr::fields {

/// The input of a filter. What its row doesn't request may be empty or null. A filter does not get the empty scene,
/// only the difference object; another way to compare with the empty scene is a norm (NormRow in planes.h).
struct FilterInput {
    const media::Frame& frame;
    const Planes& smooth;                        ///< the frame, smoothed by the setting
    const Planes* previous;                      ///< the previous frame, smoothed; null at the first
    const Plane<std::uint8_t>& object;           ///< the difference object
    const Plane<std::uint8_t>* previous_object;  ///< of the previous frame; null at the first
    const Plane<std::uint8_t>& darker;           ///< not 0 where the frame is darker than the empty scene
    const Flow& flow;                            ///< empty if none was computed
};

/// Computes the scalar field of `input.frame`, in its size: one 8-bit value per pixel, 0 = background. Called from
/// several threads at once and in any order, unless the filter's row says `in_order`.
using Filter = std::function<Plane<std::uint8_t>(const FilterInput& input)>;

/// What a filter needs and how its output is treated.
struct FilterTraits {
    /// Its values come from the difference object. So it needs a reference, frames are aligned where the camera shakes,
    /// `threshold` is that of the object, and neither `gain` nor `min_area` is applied to the values.
    bool object = false;
    bool colour = false;        ///< frames are decoded in colour; those of grey clips have none
    bool previous = false;      ///< needs the previous frame
    bool flow = false;          ///< needs flow at every frame
    bool in_order = false;      ///< must see every frame once and in order
    bool min_area = true;       ///< whether small blobs are removed
    bool shows_object = false;  ///< values other than 0 are objects: events and seeds are found in them
    bool darker = false;        ///< needs FilterInput::darker
    bool given = false;         ///< its values are those of FieldOptions::given_folder
    Values values = Values::strength;
    int threshold = 0;  ///< default of --threshold, in units of the values
    int gain = 1;       ///< factor of the values after the threshold
};

/// One row of the filter table.
struct FilterRow {
    std::string_view name;
    std::string_view help;
    FilterTraits traits;
    Filter (*make)(const FieldOptions& options);
    std::string_view transfer{};  ///< default transfer function; empty = that of the picture's theme
};

/// The pictures of scalar fields in a folder, by frame.
/// \throws Error io if there is none
FrameFiles open_field_files(const std::filesystem::path& folder);

/// Every filter.
std::span<const FilterRow> filters();

}  // namespace vvr::fields
