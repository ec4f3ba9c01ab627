#include "core/image/font.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>

#include <ft2build.h>
#include FT_FREETYPE_H

namespace vvr::image {
namespace {

struct CloseLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct CloseFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};

/// The code points of valid UTF-8.
std::u32string code_points(const std::string& text) {
    std::u32string points;
    for (std::size_t at = 0; at < text.size();) {
        const auto first = static_cast<std::uint8_t>(text[at++]);
        const int following = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
        char32_t point = following == 0 ? first : first & (0x3FU >> following);
        for (int k = 0; k < following && at < text.size(); ++k) {
            point = point << 6 | (static_cast<std::uint8_t>(text[at++]) & 0x3FU);
        }
        points.push_back(point);
    }
    return points;
}

void blend(const FT_Bitmap& letter, int left, int top, const Rgba& colour, Plane<Rgba>& pixels) {
    const int columns = static_cast<int>(letter.width);
    const int rows = static_cast<int>(letter.rows);
    for (int j = std::max(0, -top); j < std::min(rows, pixels.height() - top); ++j) {
        const unsigned char* const cover = letter.buffer + static_cast<std::ptrdiff_t>(j) * letter.pitch;
        for (int i = std::max(0, -left); i < std::min(columns, pixels.width() - left); ++i) {
            const float share = static_cast<float>(cover[i]) / 255;
            Rgba& pixel = pixels.at(left + i, top + j);
            pixel = share * colour + (1 - share * colour.a) * pixel;
        }
    }
}

}  // namespace

struct Font::Parts {
    std::unique_ptr<std::remove_pointer_t<FT_Library>, CloseLibrary> library;
    std::unique_ptr<std::remove_pointer_t<FT_Face>, CloseFace> face;

    /// Calls `use` with each letter of a line and the place of its bitmap's corner.
    bool for_letters(const std::string& text, int size,
                     const std::function<void(const FT_Bitmap&, int left, int top)>& use) const {
        if (!face || FT_Set_Pixel_Sizes(face.get(), 0, static_cast<FT_UInt>(size)) != 0) return false;
        int x = 0;
        for (const char32_t point : code_points(text)) {
            // A letter that can't be loaded is left out.
            if (FT_Load_Char(face.get(), point, FT_LOAD_RENDER) != 0) continue;
            const FT_GlyphSlot letter = face->glyph;
            use(letter->bitmap, x + letter->bitmap_left, -letter->bitmap_top);
            x += static_cast<int>(letter->advance.x >> 6);
        }
        return true;
    }
};

Font::Font(const std::string& file) : parts_(std::make_unique<Parts>()) {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) return;
    parts_->library.reset(library);
    FT_Face face = nullptr;
    if (FT_New_Face(library, file.c_str(), 0, &face) == 0) parts_->face.reset(face);
}

Font::~Font() = default;

std::optional<PixelBox> Font::measure(const std::string& text, int size) {
    constexpr int far = std::numeric_limits<int>::max();
    PixelBox box{far, far, -far, -far};
    const bool done = parts_->for_letters(text, size, [&](const FT_Bitmap& letter, int left, int top) {
        box.left = std::min(box.left, left);
        box.top = std::min(box.top, top);
        box.right = std::max(box.right, left + static_cast<int>(letter.width) + 1);
        box.bottom = std::max(box.bottom, top + static_cast<int>(letter.rows) + 1);
    });
    if (!done || box.left == far) return std::nullopt;
    return box;
}

bool Font::draw(Plane<Rgba>& pixels, int x, int y, const std::string& text, int size, const Rgba& colour) {
    return parts_->for_letters(text, size, [&](const FT_Bitmap& letter, int left, int top) {
        blend(letter, x + left, y + top, colour, pixels);
    });
}

}  // namespace vvr::image
