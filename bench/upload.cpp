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

#include "bench/in_turn.h"
#include "bench/lit_volume.h"
#include "bench/scale.h"
#include "gl/brick_textures.h"
#include "gl/check.h"
#include "gl/renderer.h"

namespace {

using namespace vvr;

std::span<const std::byte> bytes_of(const BrickTexels& texels) {
    if (texels.coloured.empty()) return std::as_bytes(std::span(texels.texels));
    return std::as_bytes(std::span(texels.coloured));
}

/// A texture of the brick's size that is only ever given new texels.
class BareTexture {
  public:
    BareTexture(const GladGLContext& gl, const BrickTexels& texels)
        : gl_(&gl), texels_(&texels), format_(texels.coloured.empty() ? GL_RED : GL_RGBA), texture_(gl) {
        gl.BindTexture(GL_TEXTURE_3D, texture_.id());
        gl.TexImage3D(GL_TEXTURE_3D, 0, texels.coloured.empty() ? GL_R8 : GL_RGBA8, texels.box.width(),
                      texels.box.height(), static_cast<GLsizei>(texels.layers()), 0, format_, GL_UNSIGNED_BYTE, nullptr);
        check_gl(gl, "making a texture of a brick's size");
    }

    void upload() const {
        gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl_->BindTexture(GL_TEXTURE_3D, texture_.id());
        gl_->TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, texels_->box.width(), texels_->box.height(),
                           static_cast<GLsizei>(texels_->layers()), format_, GL_UNSIGNED_BYTE,
                           bytes_of(*texels_).data());
    }

  private:
    const GladGLContext* gl_;
    const BrickTexels* texels_;
    GLenum format_;
    GlTexture texture_;
};

nlohmann::json measure(const Context& context, double scale, bool coloured, int runs) {
    const Size size = bench::scaled(Size{384, 288}, scale);
    const int layers = bench::scaled(200, scale);
    const GladGLContext& gl = context.gl();
    const Volume volume = bench::lit_volume(size, layers, 0.5, coloured);
    const Brick brick{0, layers};
    BrickTexels texels = brick_texels(volume, brick);

    const auto layout = make_layout("horseshoe", shape_for(size));
    RenderOptions options;
    options.size = {16, 16};
    options.ring = 1;
    options.window_layers = layers;
    Renderer renderer(context, *layout, options);
    BrickTextures textures(gl, BrickRing(1));
    const BareTexture bare(gl, texels);
    std::vector<std::byte> copy(bytes_of(texels).size());

    struct Way {
        const char* name;
        std::function<void()> run;
    };
    const std::vector<Way> ways{
        {"layout", [&] { texels = brick_texels(volume, brick); }},
        {"renderer", [&] { renderer.push_brick(0, texels); }},
        {"textures", [&] { textures.upload(0, texels); }},
        {"bare", [&] { bare.upload(); }},
        {"memcpy", [&] { std::memcpy(copy.data(), bytes_of(texels).data(), copy.size()); }},
    };
    std::vector<bench::Work> works;
    for (const Way& way : ways) {
        works.push_back({{}, [&gl, &way] {
                             way.run();
                             gl.Finish();
                         }});
    }
    const auto seconds = bench::in_turn(works, runs);
    check_gl(gl, "uploading bricks");
    nlohmann::json row{{"bytes", copy.size()},
                       {"texels", copy.size() / (coloured ? 4 : 1)},
                       {"format", coloured ? "RGBA8" : "R8"},
                       {"size", {texels.box.width(), texels.box.height(), texels.layers()}}};
    for (std::size_t i = 0; i < ways.size(); ++i) row["seconds"][ways[i].name] = seconds[i];
    return row;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const auto context = open_context(argc > 1 ? argv[1] : "auto");
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
