// Images: linear interpolation between the centres of pixels, in linear light.
#include "resources.glsl"

// x - floor(x), in [0, 1); 0 if x is not finite.
float unitPart(float x) {
  const float part = x - floor(x);
  return part >= 0.0 && part < 1.0 ? part : 0.0;
}

vec3 pixelOf(ImageRef image, uint x, uint y) {
  const uint pixel = y * image.width + x;
  vec3 color;
  if (HAS_FLOAT_IMAGES && (!HAS_BYTE_IMAGES || image.table == NO_TABLE)) {
    const int word = int(image.first + pixel * 3u);
    color = uintBitsToFloat(uvec3(texelFetch(imageTexels, word).x,
                                  texelFetch(imageTexels, word + 1).x,
                                  texelFetch(imageTexels, word + 2).x));
  } else {
    const uint rgb = texelFetch(imageTexels, int(image.first + pixel)).x;
    const uvec3 entry = image.table + (uvec3(rgb, rgb >> 8, rgb >> 16) & 255u);
    color = uintBitsToFloat(uvec3(texelFetch(imageTexels, int(entry.r)).x,
                                  texelFetch(imageTexels, int(entry.g)).x,
                                  texelFetch(imageTexels, int(entry.b)).x));
  }
  return color;
}

// The pixels on both sides of a position on one axis.
struct Neighbours {
  uint low, high;
  float weight;  // of the high one
};

// `place` in [-1/2, size], in pixels from the first pixel's centre. Beyond the border the image either
// repeats or continues its border pixel.
Neighbours neighboursOf(float place, uint size, bool repeats) {
  const float below = floor(place);
  const uint next = uint(int(below) + 1);
  Neighbours n;
  const uint last = size - 1u, before = min(next - 1u, last);
  const uint left = repeats ? last : 0u, right = repeats ? 0u : last;
  n.low = next == 0u ? left : before;
  n.high = next < size ? next : right;
  n.weight = place - below;
  return n;
}

// s and t in [0, 1], from the left and from the upper edge. The image always repeats in s, and in t if
// `repeats`.
vec3 imageAt(ImageRef image, float s, float t, bool repeats) {
  const Neighbours x = neighboursOf(s * float(image.width) - 0.5, image.width, true);
  const Neighbours y = neighboursOf(t * float(image.height) - 0.5, image.height, repeats);
  vec3 sum = vec3(0.0);
  // Not unrolled: an unrolled loop makes look-ups some 10 % faster but takes 45 ms more to compile.
  [[dont_unroll]] for (uint corner = 0u; corner < 4u; ++corner) {
    const bool right = (corner & 1u) != 0u, below = (corner & 2u) != 0u;
    const float weight =
        chosen(right, x.weight, 1.0 - x.weight) * chosen(below, y.weight, 1.0 - y.weight);
    const uint column = right ? x.high : x.low, row = below ? y.high : y.low;
    sum += weight * pixelOf(image, column, row);
  }
  return sum;
}
