#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/fields/field.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/video/frame.h"

namespace vvr::fields {

/// What a filter may look at. What its row doesn't ask for may be empty or null.
struct FilterInput {
    const video::Frame& frame;
    const Planes& smooth;                        ///< the frame, smoothed as the options ask
    const Planes* previous;                      ///< the same of the frame before; null at the first
    const Plane<std::uint8_t>& object;           ///< the difference object
    const Plane<std::uint8_t>* previous_object;  ///< of the frame before; null at the first
    const Plane<std::uint8_t>& darker;           ///< not 0 where the frame is darker than the empty scene
    const Flow& flow;                            ///< empty where none was computed
};

/// Turns frames into a scalar field: one 8-bit value a pixel, 0 = uninteresting.
class Filter {
  public:
    virtual ~Filter() = default;

    /// The field of `input.frame`, of the frame's size. Called from several threads at once, in any order, unless
    /// the filter's row says `in_order`.
    virtual Plane<std::uint8_t> operator()(const FilterInput& input) = 0;
};

/// What a filter needs, and what it gives.
struct FilterTraits {
    bool object = false;        ///< needs the difference object, and with it a reference frame
    bool colour = false;        ///< sees more when frames have colour
    bool previous = false;      ///< needs the frame before
    bool flow = false;          ///< needs flow at every frame
    bool in_order = false;      ///< must see every frame once and in order
    bool min_area = true;       ///< whether small blobs are removed
    bool shows_object = false;  ///< what isn't 0 is an object, and seeds may lie on it
    bool darker = false;        ///< needs to know where the frame is darker than the empty scene
    Values values = Values::strength;
    int threshold = 0;  ///< default of --threshold
    int gain = 1;       ///< by which values are multiplied after the threshold
};

/// One row of the filter table.
struct FilterRow {
    std::string_view name;
    std::string_view help;
    FilterTraits traits;
    std::unique_ptr<Filter> (*make)(const FieldOptions& options);
    std::string_view
        transfer{};  ///< the transfer function that its values are seen with; empty = as the picture's theme
};

/// Every filter.
std::span<const FilterRow> filters();

std::unique_ptr<Filter> make_difference(const FieldOptions& options);
std::unique_ptr<Filter> make_temporal(const FieldOptions& options);
std::unique_ptr<Filter> make_hull(const FieldOptions& options);
std::unique_ptr<Filter> make_bands(const FieldOptions& options);
std::unique_ptr<Filter> make_signed(const FieldOptions& options);
std::unique_ptr<Filter> make_edges(const FieldOptions& options);
std::unique_ptr<Filter> make_flow_magnitude(const FieldOptions& options);
std::unique_ptr<Filter> make_luminance(const FieldOptions& options);
std::unique_ptr<Filter> make_mog2(const FieldOptions& options);
std::unique_ptr<Filter> make_knn(const FieldOptions& options);

}  // namespace vvr::fields
