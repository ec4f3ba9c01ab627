#include "core/image/caption.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace vvr {

bool draw_caption(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour) {
    const OIIO::ImageSpec spec(picture.pixels.width(), picture.pixels.height(), 4, OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf pixels(spec, picture.pixels.pixels().data());
    // Without a font's name OpenImageIO looks for DejaVu Sans in the usual folders and in $OPENIMAGEIO_FONTS.
    const bool done = OIIO::ImageBufAlgo::render_text(pixels, x, y, text, size, "", colour,
                                                      OIIO::ImageBufAlgo::TextAlignX::Center,
                                                      OIIO::ImageBufAlgo::TextAlignY::Baseline);
    if (!done) pixels.geterror();  // taken, or OpenImageIO prints it at the end
    return done;
}

}  // namespace vvr
