#pragma once
#include <memory>
#include <string>

#include "random/generator.h"
#include "render/renderer.h"

namespace laver::test {

/// The comparison of a random scene's pictures by the device and by the reference.
struct Verdict {
  enum class Result { Passed, Refused, Failed };
  Result result = Result::Passed;
  std::string why{};       ///< a line; empty: passed
  double differing = 0;    ///< share of the pixels that differ
  double unexplained = 0;  ///< share of the pixels that the bounds of rounding do not explain
};

/// Renders scenes of one kind after another. Kernels are kept within a block of seeds.
class Court {
 public:
  Court();
  ~Court();
  Verdict judge(const RandomScene& random);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver::test
