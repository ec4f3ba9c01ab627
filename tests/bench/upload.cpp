// How fast a brick gets into its 3D texture, one channel and four: as the renderer does it, by its textures alone, by a
// bare glTexSubImage3D of the same size, and as a memcpy of the same bytes, in turn. Each waits until OpenGL is done.
// JSON on stdout.
//
//     upload [BACKEND] [RUNS] [SCALE]
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gl/brick_window.h"
#include "gl/context.h"
#include "tests/bench/in_turn.h"
#include "tests/bench/lit_volume.h"
#include "tests/bench/scale.h"

namespace {

using namespace vvr;

/// A brick's texels, all of them.
std::vector<std::byte> texels_of(const bricks::BrickLayers& layers) {
    const std::size_t count = layers.area() * static_cast<std::size_t>(layers.count());
    std::vector<std::byte> bytes(count * (layers.coloured() ? sizeof(bricks::ColouredTexel) : 1));
    if (layers.coloured()) {
        layers.fill_texels(0, std::span(reinterpret_cast<bricks::ColouredTexel*>(bytes.data()), count));
    } else {
        layers.fill_texels(0, std::span(reinterpret_cast<std::uint8_t*>(bytes.data()), count));
    }
    return bytes;
}

/// A texture of the brick's size that is only ever given new texels.
class BareTexture {
  public:
    BareTexture(const GladGLContext& gl, const bricks::BrickLayers& layers)
        : gl_(&gl),
          size_{layers.box().width(), layers.box().height()},
          layers_(static_cast<GLsizei>(layers.count())),
          format_(layers.coloured() ? GL_RGBA : GL_RED),
          texture_(gl) {
        gl.BindTexture(GL_TEXTURE_3D, texture_.id());
        gl.TexImage3D(GL_TEXTURE_3D, 0, layers.coloured() ? GL_RGBA8 : GL_R8, size_.width, size_.height, layers_, 0,
                      format_, GL_UNSIGNED_BYTE, nullptr);
        gl::check_gl(gl, "making a texture of a brick's size");
    }

    void upload(std::span<const std::byte> texels) const {
        gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl_->BindTexture(GL_TEXTURE_3D, texture_.id());
        gl_->TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size_.width, size_.height, layers_, format_, GL_UNSIGNED_BYTE,
                           texels.data());
    }

  private:
    const GladGLContext* gl_;
    Size size_;
    GLsizei layers_;
    GLenum format_;
    gl::GlTexture texture_;
};

nlohmann::json measure(const gl::Context& context, double scale, bool coloured, int runs) {
    const Size size = bench::scaled(Size{384, 288}, scale);
    const int count = bench::scaled(200, scale);
    const GladGLContext& gl = context.gl();
    const bricks::Volume volume = bench::lit_volume(size, count, 0.5, coloured);
    const bricks::BrickLayers layers(volume, {0, count});

    const auto layout = space::make_layout("horseshoe", space::shape_for(size));
    gl::BrickWindow window(gl, *layout, count, 1);
    std::int64_t next = 0;
    gl::BrickTextures textures(gl, 1);
    const BareTexture bare(gl, layers);
    std::vector<std::byte> texels = texels_of(layers);
    std::vector<std::byte> copy(texels.size());

    struct Way {
        const char* name;
        std::function<void()> run;
    };
    const std::vector<Way> ways{
        {"layout", [&] { texels = texels_of(layers); }},
        {"renderer",
         [&] {
             window.show(volume, bricks::cut_into(count, 1), next++);
             window.bind(0);
         }},
        {"textures", [&] { textures.upload(0, layers); }},
        {"bare", [&] { bare.upload(texels); }},
        {"memcpy", [&] { std::memcpy(copy.data(), texels.data(), copy.size()); }},
    };
    std::vector<bench::Work> works;
    for (const Way& way : ways) {
        works.push_back({{}, [&gl, &way] {
                             way.run();
                             gl.Finish();
                         }});
    }
    const auto seconds = bench::in_turn(works, runs);
    gl::check_gl(gl, "uploading bricks");
    nlohmann::json row{{"bytes", copy.size()},
                       {"texels", copy.size() / (coloured ? 4 : 1)},
                       {"format", coloured ? "RGBA8" : "R8"},
                       {"size", {layers.box().width(), layers.box().height(), layers.count()}}};
    for (std::size_t i = 0; i < ways.size(); ++i) row["seconds"][ways[i].name] = seconds[i];
    return row;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const auto context = gl::open_context(argc > 1 ? argv[1] : "auto");
        const int runs = argc > 2 ? std::stoi(argv[2]) : 9;
        const double scale = argc > 3 ? std::stod(argv[3]) : 1;
        const nlohmann::json report{
            {"renderer", context->renderer()},
            {"version", context->version()},
            {"bricks", {measure(*context, scale, false, runs), measure(*context, scale, true, runs)}}};
        fmt::print("{}\n", report.dump());
    } catch (const std::exception& error) {
        fmt::print(stderr, "upload: {}\n", error.what());
        return 1;
    }
}
