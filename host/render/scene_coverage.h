#pragma once
#include "render/coverage.h"
#include "render/packed.h"

namespace laver {

/// Pixels whose camera rays may hit a box of the tree; empty if the kernels trace no rays.
Coverage coverageOf(const Packed& packed);

}  // namespace laver
