#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/detector/classes.h"
#include "core/tracking/event.h"

namespace vvr::tracking {

/// What a detector tells of one picture of an object.
struct Look {
    const detector::ObjectClass* what = nullptr;  ///< null = nothing that it knows
    double score = 0;                             ///< 0 to 1
    Moment at{};                                  ///< of the picture
    PixelBox box{};                               ///< of the object, as the detector sees it, field pixels
};

/// What several looks at one object tell. The groups vote, each look with its score, because classes of one group are
/// often confused; the best look of that group gives the class. Nothing if no look has enough score.
std::optional<Identity> identity_of(std::span<const Look> looks);

/// Sets the identities of events, joins those that the detector sees as one object, and refutes claims: a person, a
/// vehicle or an animal was not left or taken, it stood. Looks that show nothing refute nothing: at night a detector
/// sees no people.
///
/// \param looks one list per event, empty = nobody looked
void identify(Findings& found, std::span<const std::vector<Look>> looks);

}  // namespace vvr::tracking
