#include "gl/program_sources.h"

#include <algorithm>
#include <initializer_list>

namespace vvr::gl {

namespace {

ProgramSource source(std::string name, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment) {
    ProgramSource source{std::move(name), {}, {}};
    std::ranges::transform(vertex, std::back_inserter(source.vertex), shader_chunk);
    std::ranges::transform(fragment, std::back_inserter(source.fragment), shader_chunk);
    return source;
}

}  // namespace

ProgramSource arrow_program(Channels channels) {
    if (channels == Channels::pixel_data) return source("the arrows' pixel data", {"arrow.vert"}, {"pixel_data.frag"});
    return source("the arrows", {"arrow.vert"}, {"arrow.frag"});
}

ProgramSource traceline_program(Channels channels) {
    if (channels == Channels::pixel_data) {
        return source("the tracelines' pixel data", {"trace.vert"}, {"pixel_data.frag"});
    }
    return source("the tracelines", {"trace.vert"}, {"trace.frag"});
}

ProgramSource frame_program(Channels channels) {
    if (channels == Channels::pixel_data) {
        return source("the standing frames' pixel data", {"picture.vert"},
                      {"pixel_data_over.glsl", "pixel_data_picture.frag"});
    }
    return source("the standing frames", {"picture.vert"}, {"picture.frag"});
}

ProgramSource line_program() {
    return source("the lines", {"line.vert"}, {"line.frag"});
}

ProgramSource floor_program() {
    return source("the floor", {"picture.vert"}, {"floor.frag"});
}

ProgramSource resolve_program() {
    return source("the joined samples", {"resolve.vert"}, {"resolve.frag"});
}

ProgramSource volume_program(const space::Layout& layout, VolumeColour colour, VolumeShading shading,
                             Channels channels) {
    const std::string_view map = layout.shader();
    const std::string_view optical = row_of(colour).shader;
    if (channels == Channels::pixel_data) {
        return source("the volume's pixel data", {map, "volume.vert"},
                      {map, "volume_sample.glsl", optical, "pixel_data_over.glsl", "pixel_data_volume.frag"});
    }
    const std::string_view shaded = std::ranges::find(volume_shadings(), shading, &VolumeShadingRow::shading)->shader;
    return source("the volume", {map, "volume.vert"}, {map, "volume_sample.glsl", optical, shaded, "volume.frag"});
}

void set_layout(const Program& program, const space::Layout& layout) {
    for (const space::LayoutUniform& uniform : layout.uniforms())
        program.set(uniform.name, static_cast<float>(uniform.value));
}

}  // namespace vvr::gl
