// A background image around the scene, by latitude and longitude.
#include "texture/image.glsl"
#include "texture/angle.glsl"
#include "shared/direction.h"

// A direction in the image's space, of any length.
vec3 imageDirection(vec3 direction) {
  return vec3(dotProduct(params.backgroundX, direction), dotProduct(params.backgroundY, direction),
              dotProduct(params.backgroundZ, direction));
}

// Position in the image, from its left and upper edge, in [0, 1].
vec2 imagePlace(vec3 d) {
  return vec2(unitPart(turnOf(d.x, -d.z)), 2.0 * turnOf(sqrt(d.x * d.x + d.z * d.z), d.y));
}

vec3 backgroundAt(vec3 direction) {
  if (params.backgroundImage.width == 0u) return params.backgroundRadiance;
  const vec2 place = imagePlace(imageDirection(direction));
  return params.backgroundRadiance * imageAt(params.backgroundImage, place.x, place.y, false);
}

// Density per solid angle of the world of a unit direction w that is drawn uniformly in a cell. The solid angle
// of a cell is 4 pi / columns * sin(pi / (2 rows)) times the sine of its middle latitude; the linear map N to
// the image's space changes it around w by the factor |det N| / |N w|^3. params.cellDensity has what all share.
float cellDensity(uint row, vec3 direction) {
  const vec3 d = imageDirection(direction);
  const float middle = cosSinOfTurn((float(row) + 0.5) / float(params.backgroundCells.y) * 0.5).y;
  const float squared = dotProduct(d, d);
  return params.cellDensity / (middle * squared * sqrt(squared));
}

// A cell of the image is a source.
vec3 sampleBackground(Source source, vec2 numbers, out float density, out vec3 radiance) {
  const uint row = source.index / params.backgroundCells.x;
  const uint column = source.index - row * params.backgroundCells.x;
  const vec2 cells = vec2(params.backgroundCells);
  const vec2 turn = cosSinOfTurn((float(column) + numbers.x) / cells.x);
  // Uniform between the cosines of both latitudes.
  const float top = cosSinOfTurn(float(row) / cells.y * 0.5).x;
  const float bottom = cosSinOfTurn(float(row + 1u) / cells.y * 0.5).x;
  const float height = top + (bottom - top) * numbers.y;
  const float radius = sqrt(greater(1.0 - height * height, 0.0));
  const vec3 d = vec3(radius * turn.y, height, -radius * turn.x);
  // The inverse of the rows' matrix, times its determinant.
  const vec3 x = crossProduct(params.backgroundY, params.backgroundZ);
  const vec3 y = crossProduct(params.backgroundZ, params.backgroundX);
  const vec3 z = crossProduct(params.backgroundX, params.backgroundY);
  const float side = dotProduct(params.backgroundX, x) < 0.0 ? -1.0 : 1.0;
  const vec3 direction = unitOr((x * d.x + y * d.y + z * d.z) * side, params.backgroundY);
  density = cellDensity(row, direction) * source.probability;
  radiance = backgroundAt(direction);
  return direction;
}

float backgroundDensity(vec3 direction) {
  const vec3 unit = unitOr(direction, params.backgroundY);
  const vec2 cells = vec2(params.backgroundCells), place = imagePlace(imageDirection(unit)) * cells;
  const uint column = uint(lesser(place.x, cells.x - 1.0));
  const uint row = uint(lesser(place.y, cells.y - 1.0));
  const int source = int(params.backgroundSource + row * params.backgroundCells.x + column);
  return cellDensity(row, unit) * uintBitsToFloat(texelFetch(sourceTexels, source).w);
}
