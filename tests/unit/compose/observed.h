#pragma once

#include <memory>

#include "cli/compose/compose.h"
#include "cli/plan/make_plan.h"
#include "tests/support/fields.h"

namespace vvr::test {

/// What an observer found in a volume, without frames of a camera.
inline app::Observation observed(const volume::Volume& volume) {
    app::Observation seen{volume};
    const volume::Layer& last = volume.layer(volume.layers() - 1);
    seen.last = std::make_shared<const media::Frame>(media::Frame{last.last_frame, last.last_pts, {}, {}});
    return seen;
}

/// What a picture of a volume shows.
inline app::Composition composed_of(const app::RenderJob& job, const app::Observation& seen) {
    return app::compose(app::make_plan(job, {.field_size = seen.volume.size()}), seen);
}

inline app::Composition composed_of(const app::RenderJob& job, const volume::Volume& volume) {
    return composed_of(job, observed(volume));
}

}  // namespace vvr::test
