#pragma once
#include "image/bitmap.h"
#include "image/image.h"
#include "show/view.h"
#include "show/view_layers.h"

namespace laver {

/// Around the picture.
inline constexpr Rgb8 kSurround = {48, 48, 48};

/// What a window of width x height pixels shows of a layer of `a` or `b`, or of their difference,
/// which is drawn as `laver compare` draws it: the largest over the layer's channels. A pixel of
/// the picture is drawn as one colour; where it is smaller than the window's, up to 4 x 4 of them
/// make one, by their mean or their largest difference. At exposure 0 colours are those of the
/// PNG. `b` may be null unless the view's mode asks for it.
Bitmap compose(const Image& a, const Image* b, const ViewLayer& layer, const View& view, int width,
               int height);

}  // namespace laver
