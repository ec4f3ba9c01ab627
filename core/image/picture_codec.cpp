#include "core/image/picture_codec.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <thread>

#include <dlfcn.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr::image {

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int search = 0;  // AddressSanitizer doesn't support RTLD_DEEPBIND
#else
// Its 250 libraries then resolve symbols among themselves first, not in the program's 150 libraries: half the time.
constexpr int search = RTLD_DEEPBIND;
#endif

const PictureCodec& load() {
    // One of the dependencies, log4cplus, starts a thread per core when loaded, and at least four. If that fails, it
    // aborts or waits forever.
    check_threads(std::max(4U, std::thread::hardware_concurrency()));
    // Never closed, because some of the dependencies crash when unloaded.
    constexpr int how = RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE | search;
    void* const library = while_loading([] { return dlopen(VVR_PICTURE_CODEC, how); });
    void* const codec = library ? dlsym(library, picture_codec_symbol) : nullptr;
    if (codec) return *reinterpret_cast<const PictureCodec* (*)()>(codec)();
    const char* const why = dlerror();
    const std::string text = why == nullptr ? "" : why;
    // Includes the 250 dependencies.
    constexpr std::int64_t bytes_of_all = 200'000'000;
    const bool short_of_memory =
        std::ranges::any_of(std::array{"allocate memory", "failed to map segment", "out of memory"},
                            [&](const char* words) { return text.find(words) != std::string::npos; });
    if (short_of_memory || !is_memory_available(bytes_of_all)) {
        throw Error(
            ErrorCode::out_of_memory,
            fmt::format("out of memory while loading the library for picture files: {}; give vvr more memory", text));
    }
    throw Error(ErrorCode::io, fmt::format("cannot load the library for picture files: {}; reinstall vvr", text));
}

}  // namespace

const PictureCodec& openimageio_codec() {
    static const PictureCodec& codec = load();
    return codec;
}

}  // namespace vvr::image
