#include "core/image/text.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include "core/base/plane.h"
#include "core/base/text.h"
#include "core/image/picture.h"

#include FT_FREETYPE_H

namespace vvr::image {
namespace {

struct CloseLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct CloseFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};

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

/// A font, rendered by FreeType. Not thread-safe.
class Font {
  public:
    /// \param file font file; if FreeType can't read it, no text is drawn
    explicit Font(const std::string& file) {
        FT_Library library = nullptr;
        if (FT_Init_FreeType(&library) != 0) return;
        library_.reset(library);
        FT_Face face = nullptr;
        if (FT_New_Face(library, file.c_str(), 0, &face) == 0) face_.reset(face);
    }

    /// The bounding box of a line of UTF-8 text whose baseline begins at 0,0, in pixels.
    /// \param size font size, pixels
    std::optional<PixelBox> measure(const std::string& text, int size) {
        constexpr int far = std::numeric_limits<int>::max();
        PixelBox box{far, far, -far, -far};
        const bool done = for_letters(text, size, [&](const FT_Bitmap& letter, int left, int top) {
            box.left = std::min(box.left, left);
            box.top = std::min(box.top, top);
            box.right = std::max(box.right, left + static_cast<int>(letter.width) + 1);
            box.bottom = std::max(box.bottom, top + static_cast<int>(letter.rows) + 1);
        });
        if (!done || box.left == far) return std::nullopt;
        return box;
    }

    /// Draws a line of UTF-8 text over `pixels`. Its baseline begins at `x`,`y`.
    /// \returns false if there is no font, and then draws nothing
    bool draw(Plane<Rgba>& pixels, int x, int y, const std::string& text, int size, const Rgba& colour) {
        return for_letters(text, size, [&](const FT_Bitmap& letter, int left, int top) {
            blend(letter, x + left, y + top, colour, pixels);
        });
    }

  private:
    /// Calls `use` with each glyph of a line of UTF-8 text and the position of its bitmap's corner.
    bool for_letters(const std::string& text, int size,
                     const std::function<void(const FT_Bitmap&, int left, int top)>& use) const {
        if (!face_ || FT_Set_Pixel_Sizes(face_.get(), 0, static_cast<FT_UInt>(size)) != 0) return false;
        int x = 0;
        for (std::string_view rest = text; !rest.empty();) {
            const Character character = first_character(rest).value_or(Character{U'?', 1});
            rest.remove_prefix(character.length);
            // Skips a glyph that can't be loaded.
            if (FT_Load_Char(face_.get(), character.code, FT_LOAD_RENDER) != 0) continue;
            const FT_GlyphSlot letter = face_->glyph;
            use(letter->bitmap, x + letter->bitmap_left, -letter->bitmap_top);
            x += static_cast<int>(letter->advance.x >> 6);
        }
        return true;
    }

    std::unique_ptr<std::remove_pointer_t<FT_Library>, CloseLibrary> library_;
    std::unique_ptr<std::remove_pointer_t<FT_Face>, CloseFace> face_;
};

/// The file of fontconfig's sans serif font; empty if there is none.
std::string find_font() {
    const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfigAndFonts(), FcConfigDestroy);
    const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(
        FcNameParse(reinterpret_cast<const FcChar8*>("sans:scalable=true")), FcPatternDestroy);
    if (!config || !pattern) return {};
    FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> font(
        FcFontMatch(config.get(), pattern.get(), &result), FcPatternDestroy);
    FcChar8* file = nullptr;
    if (!font || FcPatternGetString(font.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(file);
}

void add_all(FcStrList* list, std::vector<std::filesystem::path>& places) {
    if (list == nullptr) return;
    while (const FcChar8* const place = FcStrListNext(list)) places.emplace_back(reinterpret_cast<const char*>(place));
    FcStrListDone(list);
}

/// The font of all text, loaded on first use.
struct TextFont {
    std::mutex mutex;
    std::string file = find_font();
    Font font{file};
};

TextFont& text_font() {
    static TextFont font;
    return font;
}

/// Calls `use` with the font of all text. Thread-safe.
template <class Use>
auto with_font(const Use& use) {
    TextFont& text = text_font();
    const std::scoped_lock lock(text.mutex);
    return use(text.font);
}

}  // namespace

std::vector<std::filesystem::path> font_places() {
    std::vector<std::filesystem::path> places;
    const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfig(), FcConfigDestroy);
    if (!config) return places;
    add_all(FcConfigGetConfigFiles(config.get()), places);
    add_all(FcConfigGetFontDirs(config.get()), places);
    add_all(FcConfigGetCacheDirs(config.get()), places);
    return places;
}

std::string printable(const std::string& text) {
    std::string result;
    for (std::string_view rest = text; !rest.empty();) {
        const std::optional<Character> character = first_character(rest);
        const std::size_t length = character ? character->length : 1;
        const bool control = character && (character->code < 0x20 || character->code == 0x7F);
        result += !character ? "?" : control ? " " : rest.substr(0, length);
        rest.remove_prefix(length);
    }
    return result;
}

std::string font_name() {
    return std::filesystem::path(text_font().file).filename().string();
}

std::optional<PixelBox> measure_text(const std::string& text, int size) {
    return with_font([&](Font& font) { return font.measure(text, size); });
}

bool draw_text(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour) {
    return with_font([&](Font& font) { return font.draw(picture.pixels, x, y, text, size, colour); });
}

bool draw_text_centred(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour) {
    const std::optional<PixelBox> box = measure_text(text, size);
    return box && draw_text(picture, x - (box->left + box->right) / 2, y, text, size, colour);
}

}  // namespace vvr::image
