#include "core/image/codec.h"

#include <algorithm>
#include <array>
#include <latch>
#include <string>
#include <thread>
#include <vector>

#include <dlfcn.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/loading.h"
#include "core/base/machine_memory.h"

namespace vvr::image {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int search = 0;  // AddressSanitizer refuses any other
#else
// Of its 250 libraries the symbols are looked up there first, not in the program's own 150: half the time.
constexpr int search = RTLD_DEEPBIND;
#endif

/// One of its libraries, log4cplus, starts a thread per core as it is loaded, four at least. Where it can't have them
/// it ends the program or waits for ever, so that is tried first. \throws std::system_error when there are not so many
void check_threads() {
    const unsigned wanted = std::max(4U, std::thread::hardware_concurrency());
    std::latch all_there(1);
    std::vector<std::jthread> threads;
    threads.reserve(wanted);
    try {
        for (unsigned i = 0; i < wanted; ++i) threads.emplace_back([&] { all_there.wait(); });
    } catch (...) {
        all_there.count_down();
        throw;
    }
    all_there.count_down();
}

const PictureCodec& load() {
    check_threads();
    // Never closed: some of the libraries that come with it crash when they are.
    constexpr int how = RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE | search;
    void* const library = while_loading([] { return dlopen(VVR_PICTURE_CODEC, how); });
    void* const codec = library ? dlsym(library, picture_codec_symbol) : nullptr;
    if (codec) return *reinterpret_cast<const PictureCodec* (*)()>(codec)();
    const char* const why = dlerror();
    const std::string text = why == nullptr ? "" : why;
    // With the 250 libraries it depends on.
    constexpr std::int64_t bytes_of_all = 200'000'000;
    const bool short_of_memory =
        std::ranges::any_of(std::array{"allocate memory", "failed to map segment", "out of memory"},
                            [&](const char* words) { return text.find(words) != std::string::npos; });
    if (short_of_memory || !is_memory_available(bytes_of_all)) {
        throw Error(ErrorKind::limit,
                    fmt::format("out of memory for the library that reads and writes pictures: {}; allow the program "
                                "more",
                                text));
    }
    throw Error(ErrorKind::io,
                fmt::format("cannot load the library that reads and writes pictures: {}; install vvr again", text));
}

}  // namespace

const PictureCodec& picture_codec() {
    static const PictureCodec& codec = load();
    return codec;
}

}  // namespace vvr::image
