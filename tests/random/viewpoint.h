#pragma once
#include <string>

#include "random/draw.h"
#include "random/kinds.h"

namespace laver::test {

/// A camera that sees something of unit surfaces around the origin: from near, from far, from
/// inside, through tiny and wide fields of view, between clip planes, mirrored and sheared.
void chooseView(const Kind& kind, Scene& scene, Draw& draw, std::string& traits);

}  // namespace laver::test
