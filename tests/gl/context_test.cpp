#include "gl/context.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "tests/support/errors.h"
#include "tests/support/ray_caster.h"
#include "tests/support/volumes.h"

namespace vvr {
namespace {

TEST(Context, SoftwareAndOsmesaDrawTheSamePicture) {
    const volume::Volume volume = test::wandering_balls({48, 36}, 96);
    test::Shot shot;
    shot.options.size = {320, 200};
    shot.scene.lines =
        scene::volume_outline(*space::make_layout("horseshoe", space::shape_for(volume.size())), {0.5F, 0.5F, 0.5F, 1});
    const test::Drawn software = draw_volume(volume, shot);
    shot.backend = "osmesa";
    const test::Drawn osmesa = draw_volume(volume, shot);
    EXPECT_LE(test::max_difference(software.picture, osmesa.picture), 2);
}

TEST(Tiles, CoverEachPixelOnce) {
    constexpr Size picture{7, 5};
    for (const std::int64_t pixels : {1, 3, 7, 16, 100}) {
        Plane<int> covered(picture);
        for (const PixelBox& tile : gl::cut_tiles(picture, pixels)) {
            EXPECT_LE(std::int64_t{tile.width()} * tile.height(), pixels);
            ASSERT_TRUE((PixelBox{0, 0, picture.width, picture.height}.contains(tile))) << pixels;
            for (int j = tile.top; j < tile.bottom; ++j) {
                for (int i = tile.left; i < tile.right; ++i) ++covered.at(i, j);
            }
        }
        EXPECT_EQ(std::ranges::count(covered.pixels(), 1), picture.width * picture.height) << pixels;
    }
}

TEST(Context, AutoOpensWhatThereIs) {
    const auto context = gl::open_context();
    EXPECT_FALSE(context->renderer().empty());
    EXPECT_FALSE(context->version().empty());
}

TEST(Context, TheDriverIsHeard) {
    for (const char* backend : {"software", "osmesa"}) {
        std::vector<std::string> messages;
        const auto context = gl::open_context(backend, -1, [&](const std::string& text) { messages.push_back(text); });
        EXPECT_EQ(messages, std::vector<std::string>{}) << backend;
        context->gl().Enable(GL_VENDOR);
        ASSERT_EQ(messages.size(), 1U) << backend;
        EXPECT_EQ(messages.front().rfind("OpenGL, error: GL_INVALID_ENUM in glEnable", 0), 0U) << messages.front();
    }
}

TEST(Context, ProbeReportsEveryBackend) {
    const std::vector<gl::BackendReport> reports = gl::probe_backends();
    ASSERT_EQ(reports.size(), 3U);
    for (const gl::BackendReport& report : reports) {
        EXPECT_EQ(report.works, report.reason.empty()) << report.name;
        EXPECT_EQ(report.works, !report.renderer.empty()) << report.name;
    }
}

TEST(CheckGl, OutOfMemoryNamesOptionsThatTakeLess) {
    GladGLContext gl{};
    gl.GetError = []() -> GLenum { return GL_OUT_OF_MEMORY; };
    test::expect_error(ErrorCode::out_of_memory, [&] { gl::check_gl(gl, "uploading brick 3"); },
                       {"uploading brick 3", "smaller picture", "smaller fields", "more frames per layer"});
    gl.GetError = []() -> GLenum { return GL_NO_ERROR; };
    EXPECT_NO_THROW(gl::check_gl(gl, "drawing"));
}

const std::vector<gl::ShaderChunk> vertex = {{"corner.vert", "void main() { gl_Position = vec4(0.0); }"}};
constexpr std::string_view half =
    "uniform float share;  // of a whole\nfloat half_of(float value) { return share * value; }";

TEST(Program, ErrorNamesThePieceAndItsLine) {
    const auto context = gl::open_context("software");
    const gl::ProgramSource source{
        "the test", vertex, {{"half.glsl", half}, {"whole.frag", "out vec4 colour;\nvoid main() { colour = whole; }"}}};
    test::expect_error(ErrorCode::backend, [&] { const gl::Program program(context->gl(), source); },
                       {"the test's fragment shader (lines 1001... half.glsl 2001... whole.frag)", "2002"});
}

TEST(Program, MisspeltUniformIsABug) {
    const auto context = gl::open_context("software");
    const gl::Program program(
        context->gl(),
        {"the test",
         vertex,
         {{"half.glsl", half}, {"whole.frag", "out vec4 colour;\nvoid main() { colour = vec4(1.0); }"}}});
    program.use();
    EXPECT_NO_THROW(program.set("share", 0.5F)) << "though the compiler leaves it out";
    EXPECT_THROW(program.set("shares", 0.5F), std::logic_error);
    EXPECT_THROW(gl::shader_chunk("volumes.frag"), std::logic_error);
}

}  // namespace
}  // namespace vvr
