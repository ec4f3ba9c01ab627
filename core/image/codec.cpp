#include "core/image/codec.h"

#include <dlfcn.h>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {
namespace {

const PictureCodec& load() {
    // Never closed: libraries among those that come with it don't bear that.
    void* const library = dlopen(VVR_PICTURE_CODEC, RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
    void* const codec = library ? dlsym(library, picture_codec_symbol) : nullptr;
    if (codec) return *reinterpret_cast<const PictureCodec* (*)()>(codec)();
    throw Error(ErrorKind::io,
                fmt::format("cannot load what reads and writes pictures: {}; install vvr again", dlerror()));
}

}  // namespace

const PictureCodec& picture_codec() {
    static const PictureCodec& codec = load();
    return codec;
}

}  // namespace vvr
