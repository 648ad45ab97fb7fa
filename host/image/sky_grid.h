#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "image/picture.h"

namespace laver {

/// Cells of equal longitude and latitude of a picture of all directions, row by row, from which
/// light sampling draws.
struct SkyGrid {
  glm::ivec2 size{1};         ///< columns, rows
  std::vector<double> power;  ///< luminance times solid angle of each cell
};

/// Solid angle of each cell of a row.
double cellSolidAngle(glm::ivec2 size, int row);

/// A cell's luminance is the mean of the pixels that interpolation shows in it. It decides how
/// noisy light sampling is, not what it converges to. `raw` as for linear values of 8 bits.
SkyGrid skyGrid(const Picture& picture, bool raw);

}  // namespace laver
