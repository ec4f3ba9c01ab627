#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/scene/traceline.h"
#include "core/scene/transfer_file.h"
#include "gl/volume_slicer.h"

namespace vvr {

/// What the picture shows of the volume and the flow.
struct LookOptions {
    std::vector<std::string> show{"volume", "arrows", "outline", "frames"};
    std::string transfer = transfer_functions().front().name;  ///< or a file
    std::string colour{volume_colours().front().name};
    double opacity = 1;      ///< factor on the extinction
    double glyph_scale = 1;  ///< factor on the arrows' size
    TraceOptions traces;

    bool shows(const std::string& part) const;
    VolumeColour volume_colour() const;
};

void add_options(CLI::App& app, LookOptions& options);

}  // namespace vvr
