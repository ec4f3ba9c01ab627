#pragma once

#include <nlohmann/json.hpp>

#include "core/page/page_content.h"

// The data of a clip's page, in the order in which the page needs them.
namespace vvr::page {

/// What the page needs before anything can be done with it. The rest comes after its script.
nlohmann::ordered_json page_data(const PageContent& content);

/// The frame and the event that each pixel of the picture shows.
nlohmann::ordered_json pixel_data(const PageContent& content);

/// Stills of the clip and of its events.
nlohmann::ordered_json still_data(const PageContent& content);

/// The film in small, for clips that a browser can't play; null = there is none.
nlohmann::ordered_json preview_data(const PageContent& content);

}  // namespace vvr::page
