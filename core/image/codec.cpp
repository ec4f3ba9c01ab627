#include "core/image/codec.h"

#include <dlfcn.h>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int search = 0;  // AddressSanitizer refuses any other
#else
// Of its 250 libraries the symbols are looked up there first, not in the program's own 150: half the time.
constexpr int search = RTLD_DEEPBIND;
#endif

const PictureCodec& load() {
    // Never closed: some of the libraries that come with it crash when they are.
    void* const library = dlopen(VVR_PICTURE_CODEC, RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE | search);
    void* const codec = library ? dlsym(library, picture_codec_symbol) : nullptr;
    if (codec) return *reinterpret_cast<const PictureCodec* (*)()>(codec)();
    throw Error(
        ErrorKind::io,
        fmt::format("cannot load the library that reads and writes pictures: {}; install vvr again", dlerror()));
}

}  // namespace

const PictureCodec& picture_codec() {
    static const PictureCodec& codec = load();
    return codec;
}

}  // namespace vvr
