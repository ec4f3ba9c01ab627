#include "core/image/text.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>

#include <fontconfig/fontconfig.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/read_file.h"
#include "core/image/font.h"

namespace vvr::image {

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

/// The font of all text, found when it is first needed.
struct TextFont {
    std::mutex mutex;
    std::string file;
    std::optional<Font> font;
};

TextFont& text_font() {
    static TextFont font;
    return font;
}

/// Calls `use` with the font of all text, one thread at a time.
template <class Use>
auto with_font(const Use& use) {
    TextFont& text = text_font();
    const std::scoped_lock lock(text.mutex);
    if (!text.font) {
        if (text.file.empty()) text.file = find_font();
        text.font.emplace(text.file);
    }
    return use(*text.font);
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

void check_font(const std::filesystem::path& file) {
    check_is_file(file.string());
    if (std::error_code none; !std::filesystem::exists(file, none)) {
        throw Error(ErrorKind::io,
                    fmt::format("font: cannot read '{}': No such file or directory; check the name", file.string()),
                    {"font"});
    }
    if (!Font(file.string()).measure("0", 12)) {
        throw Error(
            ErrorKind::io,
            fmt::format("font: '{}' is no font that FreeType can read; give a .ttf or .otf file", file.string()),
            {"font"});
    }
}

void choose_font(const std::filesystem::path& file) {
    if (!file.empty()) check_font(file);
    TextFont& text = text_font();
    const std::scoped_lock lock(text.mutex);
    text.font.reset();
    text.file = file.string();
}

std::string font_name() {
    with_font([](Font&) { return true; });
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
