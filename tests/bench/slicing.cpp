// How many samples per second the volume slicer takes, beside a bare shader that fetches a texel and blends it and does
// nothing else, on the same polygons into the same framebuffer, in turn. Of the left-bag volume as one sees it, nearly
// empty, and with nothing left out. Samples are counted by an occlusion query, and again by adding up ones.
// JSON on stdout.
//
//     slicing [BACKEND] [RUNS] [SCALE]
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/scene/slices.h"
#include "gl/brick_window.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/volume_slicer.h"
#include "tests/bench/drawing.h"
#include "tests/bench/in_turn.h"
#include "tests/bench/left_bag.h"
#include "tests/bench/scale.h"

namespace {

using namespace vvr;

constexpr int k = 8;

using Query = gl::GlObject<gl::GenTraits<&GladGLContext::GenQueries, &GladGLContext::DeleteQueries>>;

// The bare shaders. The map is undone at the corners of polygons only, so what is fetched is the same within a texel,
// and nothing is left to do for a sample but to fetch and to blend.
constexpr std::string_view bare_vert = R"(
layout(location = 0) in vec3 p;
layout(location = 1) in float t_reference;
uniform mat4 clip_from_p;
uniform vec3 brick_scale;
uniform vec3 brick_offset;
out vec3 texel;
void main() {
    gl_Position = clip_from_p * vec4(p, 1.0);
    vec3 c = c_from_local(local_from_p(p, t_reference), t_reference);
    texel = c * brick_scale + brick_offset;
}
)";
constexpr std::string_view fetch_frag = R"(
in vec3 texel;
uniform sampler3D brick;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(texture(brick, texel).r); }
)";
constexpr std::string_view blend_frag = R"(
uniform float value;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(value); }
)";

gl::ProgramSource bare_program(const char* name, const space::Layout& layout, std::string_view fragment) {
    return {name, {gl::shader_chunk(layout.shader()), {"bare vertex shader", bare_vert}}, {{name, fragment}}};
}

/// A volume in k bricks, as the renderer holds it, and where it is seen from.
struct Bricks {
    Bricks(const std::shared_ptr<gl::Context>& context, const bricks::Volume& volume, Size picture)
        : drawing(context, volume, bench::paper_job(picture, k)),
          camera(drawing.renderer().camera()),
          stack(drawing.renderer().slices(drawing.window(), camera)) {}

    std::vector<scene::SliceMesh> cut_all() {
        std::vector<scene::SliceMesh> meshes;
        const auto cells = drawing.window().cells();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            meshes.push_back(
                scene::cut_slices(cells, i, drawing.layout(), scene::default_transfer_function(), camera, stack));
        }
        return meshes;
    }

    bench::Drawing drawing;
    space::Camera camera;
    scene::SliceStack stack;
};

/// The polygons of all slices, cut once and kept where OpenGL has them at hand: what is timed is only their drawing.
class ReadyPolygons {
  public:
    ReadyPolygons(const GladGLContext& gl, Bricks& bricks) : gl_(&gl), bricks_(&bricks) {
        std::vector<double> borders{0};
        for (const bricks::PlacedCells& brick : bricks.drawing.window().cells()) borders.push_back(brick.t_end);
        order_ = bricks.drawing.layout().back_to_front(bricks.camera.eye, borders);
        for (const scene::SliceMesh& mesh : bricks.cut_all()) add(mesh);
        gl.BindVertexArray(0);
        gl::check_gl(gl, "keeping polygons");
    }

    /// Draws all, as the slicer does, by the program in use.
    void draw() const {
        GLint program = 0;
        gl_->GetIntegerv(GL_CURRENT_PROGRAM, &program);
        const GLint scale = gl_->GetUniformLocation(static_cast<GLuint>(program), "brick_scale");
        const GLint offset = gl_->GetUniformLocation(static_cast<GLuint>(program), "brick_offset");
        for (const int number : order_) {
            const auto i = static_cast<std::size_t>(number);
            const Mesh& mesh = meshes_[i];
            bricks_->drawing.window().bind(i);
            const gl::TextureMap map = bricks_->drawing.window().texture_map(i);
            gl_->Uniform3fv(scale, 1, &map.scale.x);
            gl_->Uniform3fv(offset, 1, &map.offset.x);
            gl_->BindVertexArray(mesh.array.id());
            gl_->DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
            // As the slicer does: Mesa's rasteriser would keep the triangles of all bricks, out of the caches.
            gl_->Finish();
        }
        gl_->BindVertexArray(0);
    }

    std::int64_t triangles() const {
        std::int64_t sum = 0;
        for (const Mesh& mesh : meshes_) sum += mesh.count / 3;
        return sum;
    }

  private:
    struct Mesh {
        gl::GlVertexArray array;
        gl::GlBuffer vertices;
        gl::GlBuffer indices;
        GLsizei count = 0;
    };

    void add(const scene::SliceMesh& cut) {
        const GladGLContext& gl = *gl_;
        Mesh mesh{gl::GlVertexArray(gl), gl::GlBuffer(gl), gl::GlBuffer(gl), static_cast<GLsizei>(cut.indices.size())};
        gl.BindVertexArray(mesh.array.id());
        gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices.id());
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.id());
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(cut.vertices.size() * sizeof(scene::SliceVertex)),
                      cut.vertices.data(), GL_STATIC_DRAW);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(cut.indices.size() * sizeof(std::uint32_t)),
                      cut.indices.data(), GL_STATIC_DRAW);
        gl::set_attribute<scene::SliceVertex>(gl, 0, 3, 0, gl::Per::vertex);
        gl::set_attribute<scene::SliceVertex>(gl, 1, 1, offsetof(scene::SliceVertex, t_reference), gl::Per::vertex);
        meshes_.push_back(std::move(mesh));
    }

    const GladGLContext* gl_;
    Bricks* bricks_;
    std::vector<int> order_;
    std::vector<Mesh> meshes_;
};

/// The ways to draw one volume that are compared.
class Ways {
  public:
    Ways(const std::shared_ptr<gl::Context>& context, const bricks::Volume& volume, Size picture)
        : gl_(&context->gl()),
          picture_(picture),
          bricks_(context, volume, picture),
          polygons_(*gl_, bricks_),
          slicer_(*gl_, bricks_.drawing.layout(), gl::VolumeColour::transfer, gl::VolumeShading::none),
          fetching_(*gl_, bare_program("a bare fetch", bricks_.drawing.layout(), fetch_frag)),
          blending_(*gl_, bare_program("a bare blend", bricks_.drawing.layout(), blend_frag)),
          framebuffer_(*gl_, picture, 1) {
        slicer_.set_transfer(scene::default_transfer_function());
        for (const gl::Program* program : {&fetching_, &blending_}) {
            program->use();
            gl::set_layout(*program, bricks_.drawing.layout());
            program->set("clip_from_p", glm::mat4(bricks_.camera.clip_from_p()));
        }
        blending_.set("value", 1.0F / 512);
        clear();
        slicer();
        // The slicer leaves its program, with all uniforms and textures, in use.
        GLint program = 0;
        gl_->GetIntegerv(GL_CURRENT_PROGRAM, &program);
        slicing_program_ = static_cast<GLuint>(program);
    }

    nlohmann::json measure(int runs) {
        struct Way {
            const char* name;
            std::function<void()> run;
        };
        const std::vector<Way> ways{
            {"slicer", [this] { slicer(); }},           {"shader", [this] { shader(); }},
            {"fetch", [this] { polygons(fetching_); }}, {"blend", [this] { polygons(blending_); }},
            {"cutting", [this] { bricks_.cut_all(); }},
        };
        nlohmann::json row{{"triangles", polygons_.triangles()}, {"by_adding", samples_by_adding()}};
        for (const Way& way : ways) {
            clear();
            if (const std::int64_t samples = samples_of(way.run); samples > 0) row["samples"][way.name] = samples;
        }
        std::vector<bench::Work> works;
        for (const Way& way : ways) {
            works.push_back({[this] { clear(); },
                             [this, &way] {
                                 way.run();
                                 gl_->Finish();
                             }});
        }
        const auto seconds = bench::in_turn(works, runs);
        gl::check_gl(*gl_, "drawing slices");
        for (std::size_t i = 0; i < ways.size(); ++i) row["seconds"][ways[i].name] = seconds[i];
        return row;
    }

  private:
    void clear() {
        framebuffer_.bind(picture_);
        gl_->ClearColor(0, 0, 0, 0);
        gl_->DepthMask(GL_TRUE);
        gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl_->Finish();
    }

    void slicer() { slicer_.draw(bricks_.drawing.window(), bricks_.camera, bricks_.stack, {}); }

    /// The slicer's own program on polygons that are ready: its state of depth test and blending is still set.
    void shader() {
        gl_->UseProgram(slicing_program_);
        polygons_.draw();
    }

    void polygons(const gl::Program& program) {
        program.use();
        polygons_.draw();
    }

    std::int64_t samples_of(const std::function<void()>& draw) {
        const Query query(*gl_);
        gl_->BeginQuery(GL_SAMPLES_PASSED, query.id());
        draw();
        gl_->EndQuery(GL_SAMPLES_PASSED);
        GLuint samples = 0;
        gl_->GetQueryObjectuiv(query.id(), GL_QUERY_RESULT, &samples);
        return samples;
    }

    /// Each sample adds 1 to its pixel; floats are exact up to 16 million.
    std::int64_t samples_by_adding() {
        clear();
        gl_->BlendFunc(GL_ONE, GL_ONE);
        blending_.use();
        blending_.set("value", 1.0F);
        polygons_.draw();
        blending_.set("value", 1.0F / 512);
        gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        std::int64_t sum = 0;
        Plane<glm::vec4> picture(picture_);
        framebuffer_.read({0, 0, picture_.width, picture_.height}, picture);
        for (const glm::vec4& pixel : picture.pixels()) sum += std::llround(pixel.x);
        return sum;
    }

    const GladGLContext* gl_;
    Size picture_;
    Bricks bricks_;
    ReadyPolygons polygons_;
    gl::VolumeSlicer slicer_;
    gl::Program fetching_;
    gl::Program blending_;
    gl::Framebuffer framebuffer_;
    GLuint slicing_program_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::shared_ptr<gl::Context> context = gl::open_context(argc > 1 ? argv[1] : "auto");
        const int runs = argc > 2 ? std::stoi(argv[2]) : 5;
        const double scale = argc > 3 ? std::stod(argv[3]) : 1;
        const Size picture = bench::scaled(Size{1280, 1024}, scale);
        nlohmann::json report{{"renderer", context->renderer()},
                              {"version", context->version()},
                              {"width", picture.width},
                              {"height", picture.height},
                              {"volumes", nlohmann::json::array()}};
        for (const char* filter : {"difference", "luminance"}) {
            const bricks::Volume volume = bench::left_bag_volume(filter, scale);
            const double occupied = bench::occupied_share(volume);
            // What is quickly drawn can be drawn more often.
            nlohmann::json row = Ways(context, volume, picture).measure(occupied < 0.1 ? 5 * runs : runs);
            row["filter"] = filter;
            row["occupied"] = occupied;
            report["volumes"].push_back(row);
        }
        fmt::print("{}\n", report.dump());
    } catch (const std::exception& error) {
        fmt::print(stderr, "slicing: {}\n", error.what());
        return 1;
    }
}
