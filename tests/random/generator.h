#pragma once
#include <cstdint>
#include <string>

#include "random/kinds.h"
#include "scene/scene.h"

namespace laver::test {

struct RandomScene {
  Kind kind;
  Scene scene;
  std::string traits;  ///< what it was made of, a line
};

/// A small scene; the same for the same seed.
RandomScene randomScene(std::uint64_t seed);

}  // namespace laver::test
