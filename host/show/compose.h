#pragma once
#include "image/bitmap.h"
#include "image/image.h"
#include "show/view.h"
#include "show/view_layers.h"

namespace laver {

/// Colour around the image.
inline constexpr Rgb8 kSurround = {48, 48, 48};

/// The pixels of a window of width x height that shows a layer of `a` or `b`, or their difference
/// in the false colours of `laver compare`: the largest over the layer's channels. Image pixels are
/// drawn as squares of one colour. Where they are smaller than the window's pixels, up to 4 x 4 of
/// them are reduced to one, by their mean or their largest difference. At exposure 0 colours are
/// those of the PNG. `b` may be null unless the view's mode needs it.
Bitmap compose(const Image& a, const Image* b, const ViewLayer& layer, const View& view, int width,
               int height);

}  // namespace laver
