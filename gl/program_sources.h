#pragma once

#include "core/space/layout.h"
#include "gl/program.h"
#include "gl/volume_look.h"

// Every program that the renderer uses: which files in glsl/ its shaders are made of.
namespace vvr::gl {

/// What a program draws: a picture's colours, or the data of each pixel (gl/pixel_data_target.h).
enum class Channels { colour, pixel_data };

ProgramSource arrow_program(Channels channels);
ProgramSource traceline_program(Channels channels);
ProgramSource frame_program(Channels channels);
ProgramSource line_program();
ProgramSource floor_program();

/// Joins the samples of each pixel.
ProgramSource resolve_program();

ProgramSource volume_program(const space::Layout& layout, VolumeColour colour, VolumeShading shading,
                             Channels channels);

/// Sets the uniforms that the layout's shader declares, in the program in use.
void set_layout(const Program& program, const space::Layout& layout);

}  // namespace vvr::gl
