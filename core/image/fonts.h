#pragma once

#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include FT_FREETYPE_H

namespace vvr::image {

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

}  // namespace vvr::image
