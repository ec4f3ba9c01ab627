#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/image/picture.h"
#include "core/pixel_box.h"

namespace vvr {

/// A font file's letters, by FreeType. For one thread at a time.
class Font {
  public:
    /// \param file of the font; where there is none, or FreeType can't read it, no text can be written
    explicit Font(const std::string& file);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// What a line of UTF-8 covers when the line that letters stand on begins at 0,0.
    /// \param size of the letters, in pixels
    std::optional<PixelBox> measure(const std::string& text, int size);

    /// Writes a line of UTF-8 over `pixels`, from `x` on, `y` the line that letters stand on.
    /// \returns false where it can't; nothing is written then
    bool draw(Plane<Rgba>& pixels, int x, int y, const std::string& text, int size, const Rgba& colour);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace vvr
