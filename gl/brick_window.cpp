#include "gl/brick_window.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include "core/base/error.h"
#include "gl/context.h"

namespace vvr::gl {

namespace {

/// OpenGL's internal format and pixel format of a brick.
struct BrickStorage {
    GLint internal;
    GLenum format;
};

BrickStorage storage_of(const volume::BrickLayers& layers) {
    return layers.coloured() ? BrickStorage{GL_RGBA8, GL_RGBA} : BrickStorage{GL_R8, GL_RED};
}

// Texels are uploaded in slabs that fit into the L2 cache.
constexpr std::size_t slab_bytes = 512 * 1024;

/// Uploads `count` layers, starting at `first`, to the bound texture.
template <class Texel>
void upload_layers(const GladGLContext& gl, const volume::BrickLayers& layers, std::int64_t first, std::int64_t count) {
    const auto slab = std::max<std::int64_t>(1, static_cast<std::int64_t>(slab_bytes / sizeof(Texel) / layers.area()));
    std::vector<Texel> texels;
    for (const std::int64_t end = first + count; first < end; first += slab) {
        const std::int64_t depth = std::min(slab, end - first);
        texels.resize(static_cast<std::size_t>(depth) * layers.area());
        layers.fill_texels(first, texels);
        gl.TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, static_cast<GLint>(first), layers.box().width(), layers.box().height(),
                         static_cast<GLsizei>(depth), storage_of(layers).format, GL_UNSIGNED_BYTE, texels.data());
    }
}

void upload_part(const GladGLContext& gl, const volume::BrickLayers& layers, std::int64_t first, std::int64_t count) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (layers.coloured()) {
        upload_layers<volume::ColouredTexel>(gl, layers, first, count);
    } else {
        upload_layers<std::uint8_t>(gl, layers, first, count);
    }
}

}  // namespace

BrickTextures::BrickTextures(const GladGLContext& gl, int count) : gl_(&gl), slots_(static_cast<std::size_t>(count)) {}

void BrickTextures::upload(std::int64_t number, const volume::BrickLayers& layers) {
    const GladGLContext& gl = *gl_;
    const int width = layers.box().width();
    const int height = layers.box().height();
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
    if (std::max<std::int64_t>({width, height, layers.count()}) > largest) {
        throw Error(ErrorCode::picture_too_large,
                    fmt::format("a brick of {}x{} with {} layers is larger than this OpenGL's largest 3D texture ({}); "
                                "choose smaller fields or shorter bricks",
                                width, height, layers.brick().count, largest),
                    {"field-size", "brick"});
    }

    Slot* found = find(number);
    if (found == nullptr) found = find(unused);
    Slot& slot = found != nullptr ? *found : slots_[next_++ % slots_.size()];
    const bool fits = slot.texture && slot.box.width() == width && slot.box.height() == height &&
                      slot.layers == layers.count() && slot.coloured == layers.coloured();
    if (!fits) slot.texture = GlTexture(gl);
    gl.BindTexture(GL_TEXTURE_3D, slot.texture.id());
    if (!fits) {
        const GLint sampling = layers.interpolated() ? GL_LINEAR : GL_NEAREST;
        gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, sampling);
        gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, sampling);
        for (const GLenum axis : std::array<GLenum, 3>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
            gl.TexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
        }
        const BrickStorage storage = storage_of(layers);
        gl.TexImage3D(GL_TEXTURE_3D, 0, storage.internal, width, height, static_cast<GLsizei>(layers.count()), 0,
                      storage.format, GL_UNSIGNED_BYTE, nullptr);
    }
    upload_part(gl, layers, 0, layers.count());
    check_gl(gl, fmt::format("uploading brick {} ({}x{}, {} layers)", number, width, height, layers.brick().count));
    slot.number = number;
    slot.box = layers.box();
    slot.layers = layers.count();
    slot.coloured = layers.coloured();
}

void BrickTextures::update_border_layers(std::int64_t number, const volume::BrickLayers& layers) {
    const Slot* const slot = find(number);
    if (slot == nullptr) return;
    if (slot->box != layers.box()) return upload(number, layers);
    gl_->BindTexture(GL_TEXTURE_3D, slot->texture.id());
    for (const std::int64_t layer : {std::int64_t{0}, slot->layers - 1}) upload_part(*gl_, layers, layer, 1);
    check_gl(*gl_, fmt::format("uploading the border layers of brick {}", number));
}

void BrickTextures::keep_only(std::int64_t first, std::int64_t end) {
    for (Slot& slot : slots_) {
        if (slot.number < first || slot.number >= end) slot.number = unused;
    }
}

BrickTextures::Slot* BrickTextures::find(std::int64_t number) {
    const auto slot = std::ranges::find(slots_, number, &Slot::number);
    return slot == slots_.end() ? nullptr : &*slot;
}

void BrickTextures::bind(std::int64_t number, const volume::BrickLayers& layers) {
    if (find(number) == nullptr) upload(number, layers);
    gl_->BindTexture(GL_TEXTURE_3D, find(number)->texture.id());
}

BrickWindow::BrickWindow(const GladGLContext& gl, const space::Layout& layout, std::int64_t layers, int textures,
                         double margin)
    : layout_(&layout), window_layers_(static_cast<double>(layers)), margin_(margin), textures_(gl, textures) {}

void BrickWindow::show(const volume::Volume& volume, std::span<const volume::Brick> bricks, std::int64_t first,
                       const volume::VoxelStyleLookup& identify) {
    std::vector<Shown> before = std::exchange(shown_, {});
    for (const volume::Brick& brick : bricks)
        shown_.push_back({first + std::ssize(shown_), volume::BrickLayers(volume, brick, identify), {}});

    // The previous state of a brick that has the same neighbours as before, else null.
    const auto unchanged = [&](std::size_t i) -> Shown* {
        const std::int64_t index = before.empty() ? -1 : shown_[i].number - before.front().number;
        if (index < 0 || index >= std::ssize(before)) return nullptr;
        const bool same_before = (index == 0) == (i == 0);
        const bool same_after = (index + 1 == std::ssize(before)) == (i + 1 == shown_.size());
        return same_before && same_after ? &before[static_cast<std::size_t>(index)] : nullptr;
    };
    oneapi::tbb::parallel_for(std::size_t{0}, shown_.size(), [&](std::size_t i) {
        const volume::BrickLayers& layers = shown_[i].layers;
        Shown* const previous = unchanged(i);
        shown_[i].cells = previous != nullptr ? std::move(previous->cells)
                                              : volume::brick_cells(layers, t_span(layers), *layout_, margin_);
    });

    textures_.keep_only(first, first + std::ssize(shown_));
    placed_.clear();
    std::int64_t layers_before = 0;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const auto& [number, layers, cells] = shown_[i];
        if (unchanged(i) == nullptr) textures_.update_border_layers(number, layers);
        const double t_begin = static_cast<double>(layers_before) / window_layers_;
        layers_before += layers.brick().count;
        placed_.push_back({&cells, t_begin, static_cast<double>(layers_before) / window_layers_});
    }
}

double BrickWindow::t_span(const volume::BrickLayers& layers) const {
    return static_cast<double>(layers.brick().count) / window_layers_;
}

TextureMap BrickWindow::texture_map(std::size_t i) const {
    const volume::BrickLayers& brick = layers(i);
    const auto count = static_cast<double>(brick.brick().count);
    // The texture has one extra layer at each end.
    const double t_scale = count / (count + 2) / (placed_[i].t_end - placed_[i].t_begin);
    const double width = brick.box().width();
    const double height = brick.box().height();
    return {{brick.size().width / width, brick.size().height / height, t_scale},
            {-brick.box().left / width, -brick.box().top / height, 1 / (count + 2) - placed_[i].t_begin * t_scale}};
}

}  // namespace vvr::gl
