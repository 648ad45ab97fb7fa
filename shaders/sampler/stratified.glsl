// The sampler `stratified`: one sample in each of columns x rows strata of a pixel.
#include "sampler/hash.glsl"

uvec2 highProduct(uvec2 a, uvec2 b) {
  uvec2 high, low;
  umulExtended(a, b, high, low);
  return high;
}

// Each pixel starts at a random stratum, so that a render that ends early does not favour one edge of the
// pixels.
uvec2 stratifiedFraction(uvec3 hash, uint number) {
  const uint count = params.sampleCount, rows = params.samplerArguments.x;
  const uvec2 size = params.samplerArguments.yz;  // of a stratum; 0 stands for 2^32
  const uvec2 first = highProduct(uvec2(hash.z), uvec2(count));
  const uint left = count - first.x;
  const uint stratum = number < left ? first.x + number : number - left;
  // stratum / rows by the reciprocal, which may be too small by 1.
  uint column = highProduct(uvec2(stratum), size).y;
  const uint over = stratum - column * rows >= rows ? 1u : 0u;
  column += over;
  const uvec2 place = uvec2(column, stratum - column * rows);
  const uvec2 random = hashOf(uvec3(hash.xy, number)).xy;
  return place * size + mix(highProduct(random, size), random, equal(size, uvec2(0u)));
}

// Dimensions after the first are hashed.
uvec2 pairBits(uvec2 pixel, uint number, uint dimension) {
  if (dimension == 0u) {
    const uvec3 hash = hashOf(uvec3(pixel, params.seedHash));
    return cellMiddle(stratifiedFraction(hash, number));
  }
  if (dimension == 1u) {
    const uvec3 hash = hashOf(uvec3(pixel, ~params.seedHash));
    return hashOf(uvec3(hash.xy, number)).xy;
  }
  return hashedPair(pixel, number, dimension);
}
