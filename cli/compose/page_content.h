#pragma once

#include "cli/compose/compose.h"
#include "core/page/page_data.h"

namespace vvr::app {

/// What a page says of a picture. The picture itself, its settings, the moments that were kept, pieces of video and the
/// state of a stream are still missing.
page::PageContent page_content(const ComposePlan& plan, const Observation& seen, const Composition& composed);

}  // namespace vvr::app
