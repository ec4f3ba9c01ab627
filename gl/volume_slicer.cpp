#include "gl/volume_slicer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <utility>

#include <glad/gl.h>

#include "gl/context.h"
#include "gl/objects.h"

namespace vvr::gl {

namespace {

struct DeleteSync {
    const GladGLContext* gl = nullptr;
    void operator()(GLsync sync) const { gl->DeleteSync(sync); }
};

/// A fence in the command stream. Its context must be current on destruction.
class Fence {
  public:
    Fence() = default;  ///< already signalled

    /// Inserts a fence after all commands so far and flushes them.
    explicit Fence(const GladGLContext& gl) : sync_(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), DeleteSync{&gl}) {
        gl.Flush();
    }

    void wait() const {
        if (sync_) sync_.get_deleter().gl->ClientWaitSync(sync_.get(), 0, GL_TIMEOUT_IGNORED);
    }

  private:
    std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteSync> sync_;
};

}  // namespace

std::vector<DrawnPart> drawing_order(const space::Layout& layout, const glm::dvec3& from,
                                     std::span<const volume::PlacedCells> bricks, std::span<const double> standing) {
    std::vector<std::size_t> by_time(standing.size());
    std::iota(by_time.begin(), by_time.end(), std::size_t{0});
    std::ranges::sort(by_time, {}, [&](std::size_t i) { return standing[i]; });

    // A frame is a section of zero thickness. Gaps between frames without bricks are empty sections.
    std::vector<double> borders = {bricks.empty() ? 0 : bricks.front().t_begin};
    std::vector<std::optional<DrawnPart>> sections;
    const auto add = [&](std::optional<DrawnPart> part, double t_end) {
        sections.push_back(part);
        borders.push_back(t_end);
    };
    auto next = by_time.begin();
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        const double middle = (bricks[i].t_begin + bricks[i].t_end) / 2;
        for (; next != by_time.end() && standing[*next] < middle; ++next) add(DrawnPart{true, *next}, borders.back());
        add(DrawnPart{false, i}, bricks[i].t_end);
    }
    for (; next != by_time.end(); ++next) {
        if (standing[*next] > borders.back()) add(std::nullopt, standing[*next]);
        add(DrawnPart{true, *next}, borders.back());
    }
    std::vector<DrawnPart> order;
    if (sections.empty()) return order;
    for (const int section : layout.back_to_front(from, borders)) {
        const auto& part = sections[static_cast<std::size_t>(section)];
        if (part) order.push_back(*part);
    }
    return order;
}

namespace {

constexpr int palette_unit = 3;  // after those of a brick, the transfer function and the pixel data behind

}  // namespace

VolumeSlicer::VolumeSlicer(const GladGLContext& gl, const space::Layout& layout, VolumeColour colour,
                           VolumeShading shading)
    : gl_(&gl),
      layout_(&layout),
      colour_(colour),
      program_(gl, volume_program(layout, colour, shading, Channels::colour)),
      transfer_({scene::TransferPoint{}}),
      transfer_texture_(gl),
      palette_texture_(gl),
      vertex_array_(gl),
      vertices_(gl),
      indices_(gl) {
    gl.BindVertexArray(vertex_array_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    set_attribute<scene::SliceVertex>(gl, 0, 3, 0, Per::vertex);
    set_attribute<scene::SliceVertex>(gl, 1, 1, offsetof(scene::SliceVertex, t_reference), Per::vertex);
    gl.BindVertexArray(0);
    check_gl(gl, "setting up the volume slicer");
}

void VolumeSlicer::set_transfer(const scene::TransferFunction& transfer) {
    transfer_ = transfer;
    // Fine enough for lookup without interpolation, which would cost the software rasteriser four fetches.
    std::array<glm::vec4, 1021> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const glm::dvec4 optical = transfer.at(static_cast<double>(i) / 4);
        table[i] = glm::vec4(optical.x, optical.y, optical.z, optical.w * std::numbers::log2e);
    }
    gl_->BindTexture(GL_TEXTURE_2D, transfer_texture_.id());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(table.size()), 1, 0, GL_RGBA, GL_FLOAT,
                    table.data());
    check_gl(*gl_, "uploading the transfer function");
}

void VolumeSlicer::set_palette(std::span<const glm::vec4> palette) {
    gl_->BindTexture(GL_TEXTURE_2D, palette_texture_.id());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(palette.size()), 1, 0, GL_RGBA, GL_FLOAT,
                    palette.data());
    check_gl(*gl_, "uploading the palette of objects");
}

void VolumeSlicer::draw(BrickWindow& window, const space::Camera& camera, const scene::SliceStack& stack,
                        const StandingFrames& standing) {
    for_each_brick(program_, window, camera, stack, standing, [&](std::size_t, const scene::SliceMesh& mesh) {
        gl_->Enable(GL_DEPTH_TEST);
        gl_->DepthMask(GL_FALSE);
        gl_->Enable(GL_BLEND);
        gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
    });
}

void VolumeSlicer::draw_pixel_data(BrickWindow& window, const space::Camera& camera, const scene::SliceStack& stack,
                                   std::int64_t frames_per_layer, const PixelDataTarget& target,
                                   const StandingFrames& standing) {
    if (!pixel_data_program_) {
        pixel_data_program_ =
            Program(*gl_, volume_program(*layout_, colour_, VolumeShading::none, Channels::pixel_data));
    }
    std::vector<std::int64_t> first_layers = {0};
    for (std::size_t i = 0; i < window.cells().size(); ++i) {
        first_layers.push_back(first_layers.back() + window.layers(i).brick().count);
    }
    for_each_brick(*pixel_data_program_, window, camera, stack, standing,
                   [&](std::size_t i, const scene::SliceMesh& mesh) {
                       pixel_data_program_->set("texel_layers", static_cast<float>(window.layers(i).count()));
                       pixel_data_program_->set("first_layer", static_cast<float>(first_layers[i]));
                       pixel_data_program_->set("last_layer", static_cast<float>(first_layers.back() - 1));
                       pixel_data_program_->set("frames_per_layer", static_cast<float>(frames_per_layer));
                       std::size_t begin = 0;
                       const std::span<const std::size_t> all(mesh.slice_ends);
                       for (const std::size_t end : target.fetches() ? all.last(1) : all) {
                           target.draw_over(*pixel_data_program_, [&] {
                               gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(end - begin), GL_UNSIGNED_INT,
                                                 std::bit_cast<const void*>(begin * sizeof(std::uint32_t)));
                           });
                           begin = end;
                       }
                   });
}

void VolumeSlicer::use(const Program& program, const space::Camera& camera, const scene::SliceStack& stack) const {
    const GladGLContext& gl = *gl_;
    program.use();
    set_layout(program, *layout_);
    program.set("clip_from_p", glm::mat4(camera.clip_from_p()));
    program.set("eye", glm::vec3(camera.eye));
    program.set("forward", glm::vec3(camera.forward));
    program.set("frame_height", static_cast<float>(layout_->shape().y_s));
    program.set("spacing", static_cast<float>(stack.spacing));
    program.set("perspective", camera.perspective ? 1 : 0);
    program.set("to_light", to_light(camera));
    program.set("brick", 0);
    program.set("transfer", 1);
    if (row_of(colour_).uses_palette) {
        program.set("palette", palette_unit);
        gl.ActiveTexture(GL_TEXTURE0 + palette_unit);
        gl.BindTexture(GL_TEXTURE_2D, palette_texture_.id());
    }
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_2D, transfer_texture_.id());
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindVertexArray(vertex_array_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
}

void VolumeSlicer::for_each_brick(const Program& program, BrickWindow& window, const space::Camera& camera,
                                  const scene::SliceStack& stack, const StandingFrames& standing,
                                  const std::function<void(std::size_t, const scene::SliceMesh&)>& draw) {
    const std::span<const volume::PlacedCells> bricks = window.cells();
    const GladGLContext& gl = *gl_;
    Fence last;
    Fence before_last;
    bool bound = false;
    // An orthographic eye is infinitely far away.
    const glm::dvec3 from = camera.perspective ? camera.eye : camera.eye - 1e6 * camera.forward;
    for (const DrawnPart& part : drawing_order(*layout_, from, bricks, standing.times)) {
        if (part.is_frame) {
            standing.draw(part.number);
            bound = false;
            continue;
        }
        const std::size_t i = part.number;
        const scene::SliceMesh mesh = scene::cut_slices(bricks, i, *layout_, transfer_, camera, stack);
        if (mesh.indices.empty()) continue;
        if (!std::exchange(bound, true)) use(program, camera, stack);
        const TextureMap map = window.texture_map(i);
        program.set("brick_scale", map.scale);
        program.set("brick_offset", map.offset);
        // Mesa's rasteriser buffers the triangles of all pending draws, 300 bytes each, so at most one brick's wait
        // while it draws another. Where two textures alternate, the next one is then no longer read.
        before_last.wait();
        window.bind(i);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(scene::SliceVertex)),
                      mesh.vertices.data(), GL_STREAM_DRAW);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                      mesh.indices.data(), GL_STREAM_DRAW);
        draw(i, mesh);
        before_last = std::exchange(last, Fence(gl));
    }
    gl.BindVertexArray(0);
    check_gl(gl, "drawing the volume");
}

}  // namespace vvr::gl
