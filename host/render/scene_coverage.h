#pragma once
#include "render/coverage.h"
#include "render/packed.h"

namespace laver {

/// Pixels whose camera rays may meet a box of the tree; nothing where the kernels trace no rays.
Coverage coverageOf(const Packed& packed);

}  // namespace laver
