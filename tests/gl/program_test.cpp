#include "gl/program.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "gl/context.h"

namespace vvr {
namespace {

const std::vector<gl::ShaderChunk> vertex = {{"corner.vert", "void main() { gl_Position = vec4(0.0); }"}};
constexpr std::string_view half =
    "uniform float share;  // of a whole\nfloat half_of(float value) { return share * value; }";

TEST(Program, ErrorNamesThePieceAndItsLine) {
    const auto context = gl::open_context("software");
    const gl::ProgramSource source{
        "the test", vertex, {{"half.glsl", half}, {"whole.frag", "out vec4 colour;\nvoid main() { colour = whole; }"}}};
    try {
        const gl::Program program(context->gl(), source);
        FAIL();
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.kind(), ErrorKind::backend);
        EXPECT_NE(text.find("the test's fragment shader (lines 1001... half.glsl 2001... whole.frag)"), text.npos)
            << text;
        EXPECT_NE(text.find("2002"), text.npos) << text;
    }
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
