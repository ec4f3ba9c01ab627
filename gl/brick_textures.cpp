#include "gl/brick_textures.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/check.h"

namespace vvr {

namespace {

/// How the texels of a brick are stored.
struct Storage {
    GLint internal;
    GLenum format;
    std::size_t texel_bytes;
    const std::uint8_t* texels;
};

Storage storage_of(const BrickTexels& brick) {
    if (brick.coloured.empty()) return {GL_R8, GL_RED, 1, brick.texels.data()};
    return {GL_RGBA8, GL_RGBA, 4, brick.coloured.front().data()};
}

}  // namespace

BrickTextures::BrickTextures(const GladGLContext& gl, BrickRing ring)
    : gl_(&gl), ring_(ring), slots_(static_cast<std::size_t>(ring.size())) {}

void BrickTextures::upload(std::int64_t number, const BrickTexels& texels) {
    const GladGLContext& gl = *gl_;
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
    const std::int64_t longest = std::max<std::int64_t>({texels.box.width(), texels.box.height(), texels.layers()});
    if (longest > largest) {
        throw Error(ErrorKind::limit,
                    fmt::format("a brick of {}x{} with {} layers is larger than this OpenGL's largest 3D texture ({}); "
                                "take a smaller --field-size or a shorter --brick",
                                texels.box.width(), texels.box.height(), texels.brick.count, largest));
    }

    Slot& slot = slots_[static_cast<std::size_t>(ring_.slot(number))];
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto width = static_cast<GLsizei>(texels.box.width());
    const auto height = static_cast<GLsizei>(texels.box.height());
    const auto depth = static_cast<GLsizei>(texels.layers());
    const bool coloured = !texels.coloured.empty();
    const bool fits =
        slot.texture && slot.box.width() == texels.box.width() && slot.box.height() == texels.box.height() &&
        slot.layers == texels.layers() && slot.coloured == coloured;
    const Storage storage = storage_of(texels);
    if (fits) {
        gl.BindTexture(GL_TEXTURE_3D, slot.texture.id());
        gl.TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, width, height, depth, storage.format, GL_UNSIGNED_BYTE,
                         storage.texels);
    } else {
        slot.texture = GlTexture(gl);
        gl.BindTexture(GL_TEXTURE_3D, slot.texture.id());
        gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
            gl.TexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
        }
        gl.TexImage3D(GL_TEXTURE_3D, 0, storage.internal, width, height, depth, 0, storage.format, GL_UNSIGNED_BYTE,
                      storage.texels);
    }
    check_gl(gl, fmt::format("uploading brick {} ({}x{}, {} layers)", number, width, height, texels.brick.count));
    slot.number = number;
    slot.box = texels.box;
    slot.layers = texels.layers();
    slot.coloured = coloured;
}

void BrickTextures::upload_ends(std::int64_t number, const BrickTexels& texels) {
    const Slot& slot = slot_of(number);
    if (slot.box != texels.box) {
        upload(number, texels);
        return;
    }
    const Storage storage = storage_of(texels);
    const std::size_t layer_bytes =
        storage.texel_bytes * static_cast<std::size_t>(slot.box.width()) * static_cast<std::size_t>(slot.box.height());
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_->BindTexture(GL_TEXTURE_3D, slot.texture.id());
    for (const std::int64_t layer : {std::int64_t{0}, slot.layers - 1}) {
        gl_->TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, static_cast<GLint>(layer), slot.box.width(), slot.box.height(), 1,
                           storage.format, GL_UNSIGNED_BYTE,
                           storage.texels + layer_bytes * static_cast<std::size_t>(layer));
    }
    check_gl(*gl_, fmt::format("uploading the ends of brick {}", number));
}

const BrickTextures::Slot& BrickTextures::slot_of(std::int64_t number) const {
    const Slot& slot = slots_[static_cast<std::size_t>(ring_.slot(number))];
    if (slot.number != number) {
        throw Error(ErrorKind::backend,
                    fmt::format("brick {} is not in the ring: its slot holds {}", number, slot.number));
    }
    return slot;
}

void BrickTextures::bind(std::int64_t number) const {
    gl_->BindTexture(GL_TEXTURE_3D, slot_of(number).texture.id());
}

}  // namespace vvr
