#include "core/image/fonts.h"

#include <cstddef>
#include <span>

namespace vvr::image {

namespace {

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

}  // namespace

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

}  // namespace vvr::image
