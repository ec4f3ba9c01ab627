#include "core/image/text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <raqm.h>

#include "core/base/text.h"

namespace vvr::image {

namespace {

/// Releases what fontconfig and FreeType have made.
struct ReleaseFont {
    void operator()(FcConfig* config) const { FcConfigDestroy(config); }
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
    void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};

template <class Handle>
using FontHandle = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseFont>;

/// fontconfig's sans serif font, and others for characters that it lacks, opened when they are needed. Not thread-safe.
class Fonts {
  public:
    Fonts();

    /// The file of the sans serif font. Empty if there is no font.
    const std::string& file() const { return file_; }

    /// Null if there is no font, or if FreeType can't read it.
    FT_Face sans() const { return sans_; }

    /// A font with the character; null if there is none.
    FT_Face find(char32_t character);

  private:
    FT_Face open(const FcPattern& font);
    FT_Face search(char32_t character);

    FontHandle<FcConfig*> config_;
    FontHandle<FcPattern*> pattern_;
    FontHandle<FcFontSet*> sorted_;  ///< all fonts, the most similar first; made when the first character is missing
    FontHandle<FT_Library> library_;
    std::map<std::pair<std::string, int>, FontHandle<FT_Face>> opened_;  ///< by file and index; null if unreadable
    std::map<char32_t, FT_Face> found_;                                  ///< of characters that `sans` lacks
    std::string file_;
    FT_Face sans_ = nullptr;
};

FontHandle<FcPattern*> sans_pattern(FcConfig* config) {
    FontHandle<FcPattern*> pattern(FcNameParse(reinterpret_cast<const FcChar8*>("sans:scalable=true")));
    if (!config || !pattern) return nullptr;
    FcConfigSubstitute(config, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    return pattern;
}

std::string file_of(const FcPattern& font) {
    FcChar8* file = nullptr;
    if (FcPatternGetString(&font, FC_FILE, 0, &file) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(file);
}

bool has_character(const FcPattern& font, char32_t character) {
    FcCharSet* characters = nullptr;
    return FcPatternGetCharSet(&font, FC_CHARSET, 0, &characters) == FcResultMatch &&
           FcCharSetHasChar(characters, character) == FcTrue;
}

Fonts::Fonts() : config_(FcInitLoadConfigAndFonts()), pattern_(sans_pattern(config_.get())) {
    FT_Library library = nullptr;
    if (!pattern_ || FT_Init_FreeType(&library) != 0) return;
    library_.reset(library);
    FcResult result = FcResultNoMatch;
    const FontHandle<FcPattern*> font(FcFontMatch(config_.get(), pattern_.get(), &result));
    if (!font) return;
    file_ = file_of(*font);
    sans_ = open(*font);
}

FT_Face Fonts::open(const FcPattern& font) {
    int index = 0;  // in a collection of fonts
    FcPatternGetInteger(&font, FC_INDEX, 0, &index);
    const std::string file = file_of(font);
    const auto [place, is_new] = opened_.try_emplace({file, index});
    if (is_new) {
        FT_Face face = nullptr;
        if (FT_New_Face(library_.get(), file.c_str(), index, &face) == 0) place->second.reset(face);
    }
    return place->second.get();
}

FT_Face Fonts::find(char32_t character) {
    if (sans_ == nullptr || FT_Get_Char_Index(sans_, character) != 0) return sans_;
    const auto [place, is_new] = found_.try_emplace(character, nullptr);
    if (is_new) place->second = search(character);
    return place->second;
}

FT_Face Fonts::search(char32_t character) {
    if (!sorted_) {
        FcResult result = FcResultNoMatch;
        sorted_.reset(FcFontSort(config_.get(), pattern_.get(), FcTrue, nullptr, &result));
    }
    if (!sorted_) return nullptr;
    for (const FcPattern* const font : std::span(sorted_->fonts, static_cast<std::size_t>(sorted_->nfont))) {
        if (!has_character(*font, character)) continue;
        // fontconfig's caches may be out of date.
        if (FT_Face face = open(*font); face != nullptr && FT_Get_Char_Index(face, character) != 0) return face;
    }
    return nullptr;
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

constexpr FT_Int32 load_flags = FT_LOAD_NO_BITMAP;  // fonts for East Asia have black and white bitmaps for small sizes

std::u32string characters_of(std::string_view text) {
    std::u32string characters;
    while (!text.empty()) {
        const Character character = first_character(text).value_or(Character{U'?', 1});
        characters += character.code;
        text.remove_prefix(character.length);
    }
    return characters;
}

/// Whether a character is not drawn, such as a joiner, a mark of direction, or a variation selector.
bool is_invisible(char32_t character) {
    const auto is_within = [character](char32_t first, char32_t last) {
        return character >= first && character <= last;
    };
    return is_within(0x200B, 0x200F) || is_within(0x2028, 0x202E) || is_within(0x2060, 0x206F) ||
           is_within(0xFE00, 0xFE0F) || character == 0x00AD || character == 0xFEFF || is_within(0xE0000, 0xE0FFF);
}

using Layout = std::unique_ptr<raqm_t, decltype(&raqm_destroy)>;

/// Places the glyphs of a line of text, in the order of its script, with the letters' shapes and ligatures.
/// \returns null if there is no font, or no memory
Layout lay_out(Fonts& fonts, const std::string& text, int size) {
    Layout none(nullptr, raqm_destroy);
    const std::u32string characters = characters_of(text);
    Layout layout(raqm_create(), raqm_destroy);
    if (fonts.sans() == nullptr || characters.empty() || !layout) return none;
    static_assert(sizeof(char32_t) == sizeof(std::uint32_t));
    const bool ready =
        raqm_set_text(layout.get(), reinterpret_cast<const std::uint32_t*>(characters.data()), characters.size()) &&
        raqm_set_par_direction(layout.get(), RAQM_DIRECTION_LTR) &&
        raqm_set_freetype_load_flags(layout.get(), load_flags);
    if (!ready) return none;
    for (std::size_t k = 0; k < characters.size(); ++k) {
        FT_Face face = fonts.find(characters[k]);
        if (face == nullptr) face = fonts.sans();
        if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size)) != 0) return none;
        if (!raqm_set_freetype_face_range(layout.get(), face, k, 1)) return none;
    }
    if (!raqm_layout(layout.get())) return none;
    return layout;
}

/// Calls `use` with each glyph of a line of text and the position of its bitmap's corner.
/// \returns false if there is no font
bool for_glyphs(Fonts& fonts, const std::string& text, int size,
                const std::function<void(const FT_Bitmap&, int left, int top)>& use) {
    if (fonts.sans() == nullptr) return false;
    const Layout layout = lay_out(fonts, text, size);
    if (!layout) return text.empty();
    std::size_t count = 0;
    const raqm_glyph_t* const glyphs = raqm_get_glyphs(layout.get(), &count);
    int x = 0;  // in 64ths of a pixel
    for (const raqm_glyph_t& glyph : std::span(glyphs, count)) {
        // Skips a glyph that can't be loaded.
        if (FT_Load_Glyph(glyph.ftface, glyph.index, load_flags | FT_LOAD_RENDER) == 0) {
            const FT_GlyphSlot letter = glyph.ftface->glyph;
            use(letter->bitmap, ((x + glyph.x_offset) >> 6) + letter->bitmap_left,
                -(glyph.y_offset >> 6) - letter->bitmap_top);
        }
        x += glyph.x_advance;
    }
    return true;
}

/// The bounding box of a line of text whose baseline begins at 0,0, in pixels.
std::optional<PixelBox> measure(Fonts& fonts, const std::string& text, int size) {
    constexpr int far = std::numeric_limits<int>::max();
    PixelBox box{far, far, -far, -far};
    const bool done = for_glyphs(fonts, text, size, [&](const FT_Bitmap& letter, int left, int top) {
        box.left = std::min(box.left, left);
        box.top = std::min(box.top, top);
        box.right = std::max(box.right, left + static_cast<int>(letter.width) + 1);
        box.bottom = std::max(box.bottom, top + static_cast<int>(letter.rows) + 1);
    });
    if (!done || box.left == far) return std::nullopt;
    return box;
}

/// The fonts of all text, found on first use.
struct TextFonts {
    std::mutex mutex;
    Fonts fonts;
};

/// Calls `use` with the fonts of all text. Thread-safe.
template <class Use>
auto with_fonts(const Use& use) {
    static TextFonts text;
    const std::scoped_lock lock(text.mutex);
    return use(text.fonts);
}

void add_all(FcStrList* list, std::vector<std::filesystem::path>& places) {
    if (list == nullptr) return;
    while (const FcChar8* const place = FcStrListNext(list)) places.emplace_back(reinterpret_cast<const char*>(place));
    FcStrListDone(list);
}

}  // namespace

std::vector<std::filesystem::path> font_places() {
    std::vector<std::filesystem::path> places;
    const FontHandle<FcConfig*> config(FcInitLoadConfig());
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
    return with_fonts([](const Fonts& fonts) { return std::filesystem::path(fonts.file()).filename().string(); });
}

std::set<std::string> missing_characters(const std::string& text) {
    std::set<std::string> missing;
    with_fonts([&](Fonts& fonts) {
        if (fonts.sans() == nullptr) return;
        for (std::string_view rest = text; !rest.empty();) {
            const Character character = first_character(rest).value_or(Character{U'?', 1});
            if (!is_invisible(character.code) && fonts.find(character.code) == nullptr)
                missing.emplace(rest.substr(0, character.length));
            rest.remove_prefix(character.length);
        }
    });
    return missing;
}

std::optional<PixelBox> measure_text(const std::string& text, int size) {
    return with_fonts([&](Fonts& fonts) { return measure(fonts, text, size); });
}

bool draw_text(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour) {
    return with_fonts([&](Fonts& fonts) {
        return for_glyphs(fonts, text, size, [&](const FT_Bitmap& letter, int left, int top) {
            blend(letter, x + left, y + top, colour, picture.pixels);
        });
    });
}

bool draw_text_centred(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour) {
    const std::optional<PixelBox> box = measure_text(text, size);
    return box && draw_text(picture, x - (box->left + box->right) / 2, y, text, size, colour);
}

}  // namespace vvr::image
