#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/fields/field.h"
#include "core/fields/options.h"
#include "core/fields/reference.h"
#include "core/video/frame.h"

namespace vvr {

/// What a filter may look at. What its row doesn't ask for may be null.
struct FilterInput {
    const Frame& frame;
    const Frame* previous;  ///< null at the first frame
    const Flow* flow;
};

/// Turns frames into a scalar field: one 8-bit value a pixel, 0 = uninteresting.
class Filter {
  public:
    virtual ~Filter() = default;

    /// The field of `input.frame`, of the frame's size. Called from several threads at once.
    virtual Plane<std::uint8_t> operator()(const FilterInput& input) const = 0;
};

/// What has to be there before a filter can work.
struct FilterNeeds {
    bool reference = false;
    bool colour = false;  ///< works better with it
    bool previous = false;
    bool flow = false;
};

/// One row of the filter table.
struct FilterRow {
    std::string_view name;
    std::string_view help;
    FilterNeeds needs;
    std::unique_ptr<Filter> (*make)(const FieldOptions& options, const Reference& reference);
};

/// Every filter.
std::span<const FilterRow> filters();

/// The row of that name.
/// \throws Error usage when there is none
const FilterRow& find_filter(std::string_view name);

/// Difference against the reference frame: the largest of the channels' differences, twice, 255 at most, and 0
/// below the threshold (§4, Fig. 4a). Twice, because people and bags seldom differ by more than half the range.
std::unique_ptr<Filter> make_difference(const FieldOptions& options, const Reference& reference);

}  // namespace vvr
