#pragma once

#include <filesystem>
#include <string>

#include "cli/render/report.h"
#include "core/image/picture.h"
#include "core/page/watched_fields.h"

namespace vvr {

/// The text of the page for a picture that has its pixel data.
/// \param path where the page goes
/// \param input as the user gave it; a file is played from where it is, anything else from the page's own preview
/// \param title above the page; empty = the input's name
std::string page_text(const std::filesystem::path& path, const std::string& input, const std::string& title,
                      const RenderReport& report, Picture picture, const Metadata& settings, Moments moments);

}  // namespace vvr
