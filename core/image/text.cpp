#include "core/image/text.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>

#include <fontconfig/fontconfig.h>

#include "core/image/font.h"

namespace vvr {

namespace {

/// The file of fontconfig's sans serif font, empty when there is none.
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

/// Calls `use` with the font of all text, one thread at a time.
template <class Use>
auto with_font(const Use& use) {
    static std::mutex mutex;
    static Font font(find_font());
    const std::scoped_lock lock(mutex);
    return use(font);
}

/// Length in bytes of the UTF-8 sequence at `at`; 0 if it is not one.
std::size_t sequence_length(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(at);
    std::size_t length = 0;
    if (first < 0x80) length = 1;
    if (first >= 0xC2 && first < 0xE0) length = 2;
    if (first >= 0xE0 && first < 0xF0) length = 3;
    if (first >= 0xF0 && first < 0xF5) length = 4;
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t i = at + 1; i < at + length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
    }
    return length;
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
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequence_length(text, at);
        const auto byte = static_cast<std::uint8_t>(text[at]);
        if (length == 0) {
            result += '?';
        } else if (byte < 0x20 || byte == 0x7F) {
            result += ' ';
        } else {
            result.append(text, at, length);
        }
        at += std::max<std::size_t>(length, 1);
    }
    return result;
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

}  // namespace vvr
