#include "core/image/caption.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace vvr {
namespace {

namespace fs = std::filesystem;

// Plain sans serifs, the first of them that is installed. OpenImageIO itself only looks for one that few systems have.
constexpr std::array fonts{"DejaVuSans.ttf", "LiberationSans-Regular.ttf", "NotoSans-Regular.ttf", "DroidSans.ttf",
                           "Arial.ttf"};

fs::path find_in(const fs::path& folder, const char* font) {
    std::error_code error;
    constexpr auto lenient = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator at(folder, lenient, error), end; !error && at != end; at.increment(error)) {
        if (at->path().filename() == font) return at->path();
    }
    return {};
}

fs::path find_font() {
    const char* const asked = std::getenv("OPENIMAGEIO_FONTS");
    for (const fs::path folder : {asked == nullptr ? "" : asked, "/usr/share/fonts", "/usr/local/share/fonts"}) {
        for (const char* font : fonts) {
            fs::path found = find_in(folder, font);
            if (!found.empty()) return found;
        }
    }
    return {};
}

}  // namespace

bool draw_caption(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour) {
    static const fs::path font = find_font();
    if (font.empty()) return false;
    const OIIO::ImageSpec spec(picture.pixels.width(), picture.pixels.height(), 4, OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf pixels(spec, picture.pixels.pixels().data());
    const bool done = OIIO::ImageBufAlgo::render_text(pixels, x, y, text, size, font.string(), colour,
                                                      OIIO::ImageBufAlgo::TextAlignX::Center,
                                                      OIIO::ImageBufAlgo::TextAlignY::Baseline);
    if (!done) pixels.geterror();  // taken, or OpenImageIO prints it at the end
    return done;
}

}  // namespace vvr
