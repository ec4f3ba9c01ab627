#pragma once

#include "core/image/text.h"
#include "core/pixel_box.h"

namespace vvr {

/// Which bands of text a picture has.
struct SheetParts {
    bool title = false;
    bool ruler = false;
    bool legend = false;
};

/// Where things lie on a picture: a line of title at the top, a line of legend at the bottom, the volume between them,
/// with room beside it for the ruler's labels.
struct Sheet {
    Size picture;
    int text = 0;    ///< size of the text in pixels; 0 = the picture is too small for any
    int edge = 0;    ///< pixels that stay free at the picture's borders
    PixelBox title;  ///< the bands; empty where there is none
    PixelBox legend;
    PixelBox between;  ///< what is left: labels of the ruler stay in it
    PixelBox volume;   ///< the part of the picture that the camera's own picture fills
};

Sheet arrange_sheet(Size picture, const SheetParts& parts);

}  // namespace vvr
