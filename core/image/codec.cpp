#include "core/image/codec.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <latch>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <dlfcn.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file_io.h"
#include "core/base/memory.h"
#include "core/image/picture.h"

namespace vvr::image {

namespace {

/// A picture format that can be read.
struct ReadFormat {
    std::string_view name;         ///< OpenImageIO's name
    std::string_view first_bytes;  ///< signature of its files
};

using namespace std::string_view_literals;
constexpr std::array read_formats{ReadFormat{"png", "\x89PNG\r\n\x1a\n"sv}, ReadFormat{"jpeg", "\xff\xd8\xff"sv},
                                  ReadFormat{"tiff", "II*\0"sv}, ReadFormat{"tiff", "MM\0*"sv},
                                  ReadFormat{"openexr", "\x76\x2f\x31\x01"sv}};

constexpr std::size_t longest_begin = 8;

/// \param begin first bytes of the file
std::string_view format_of(const std::filesystem::path& name, std::string_view begin) {
    const auto format =
        std::ranges::find_if(read_formats, [&](const ReadFormat& row) { return begin.starts_with(row.first_bytes); });
    if (format != read_formats.end()) return format->name;
    throw Error(ErrorCode::file_invalid,
                fmt::format("cannot read picture '{}': it is no PNG, JPEG, TIFF or OpenEXR file, {}", name.string(),
                            begin.empty() ? "but empty" : "whatever its name says; convert it"));
}

}  // namespace

Samples read_samples(const std::filesystem::path& path) {
    check_is_file(path.string(), most_bytes::data);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::array<char, longest_begin> begin{};
    file.read(begin.data(), begin.size());
    if (!file.is_open() || file.bad()) {
        throw Error(code_of_system_error(errno),
                    fmt::format("cannot read picture '{}': {}; check its name and permissions", path.string(),
                                std::strerror(errno)));
    }
    const std::string_view bytes(begin.data(), static_cast<std::size_t>(file.gcount()));
    return picture_codec().read(path, format_of(path, bytes), std::nullopt);
}

Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes) {
    const std::string_view begin(reinterpret_cast<const char*>(bytes.data()), std::min(longest_begin, bytes.size()));
    return picture_codec().read(name, format_of(name, begin), bytes);
}

Samples without_pixel_data(Samples samples) {
    const auto is_pixel_data = [](const std::string& channel) {
        return std::ranges::find(pixel_data_channels, channel, &PixelDataChannel::name) != pixel_data_channels.end();
    };
    if (std::ranges::none_of(samples.channels, is_pixel_data)) return samples;
    std::vector<float> kept;
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        if (!is_pixel_data(samples.channels[i % samples.channels.size()])) kept.push_back(samples.values[i]);
    }
    samples.values = std::move(kept);
    std::erase_if(samples.channels, is_pixel_data);
    return samples;
}

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int search = 0;  // AddressSanitizer doesn't support RTLD_DEEPBIND
#else
// Its 250 libraries then resolve symbols among themselves first, not in the program's 150 libraries: half the time.
constexpr int search = RTLD_DEEPBIND;
#endif

/// Checks that threads can be started. One of the dependencies, log4cplus, starts a thread per core when loaded, and
/// at least four. If that fails, it aborts or hangs.
/// \throws std::system_error if the threads can't be started
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
        throw Error(ErrorCode::out_of_memory,
                    fmt::format("out of memory for the library that reads and writes pictures: {}; allow the program "
                                "more",
                                text));
    }
    throw Error(ErrorCode::io,
                fmt::format("cannot load the library that reads and writes pictures: {}; install vvr again", text));
}

}  // namespace

const PictureCodec& picture_codec() {
    static const PictureCodec& codec = load();
    return codec;
}

}  // namespace vvr::image
