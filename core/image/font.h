#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/pixel_box.h"
#include "core/image/picture.h"

namespace vvr::image {

/// A font file's letters, by FreeType. For one thread at a time.
class Font {
  public:
    /// \param file of the font; if FreeType can't read it, no text can be drawn
    explicit Font(const std::string& file);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// The box of a line of UTF-8 whose baseline begins at 0,0.
    /// \param size of the letters, in pixels
    std::optional<PixelBox> measure(const std::string& text, int size);

    /// Draws a line of UTF-8 over `pixels`, its baseline from `x`,`y` on.
    /// \returns false if there is no font; nothing is drawn then
    bool draw(Plane<Rgba>& pixels, int x, int y, const std::string& text, int size, const Rgba& colour);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace vvr::image
