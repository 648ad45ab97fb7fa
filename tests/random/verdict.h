#pragma once
#include <memory>
#include <string>

#include "random/generator.h"
#include "render/renderer.h"

namespace laver::test {

/// The comparison of a random scene's pictures by the device and by the reference.
struct Verdict {
  enum class Result {
    Passed,
    Refused,    ///< an error of the exit code 4, which names a limit
    Threw,      ///< any other error
    Dropped,    ///< a sample was NaN, infinite or negative
    NotFinite,  ///< so is a pixel
    OtherBits,  ///< by another traversal
    Different   ///< from the reference
  };
  Result result = Result::Passed;
  std::string why{};       ///< a line; empty: passed
  double differing = 0;    ///< share of the pixels that differ
  double unexplained = 0;  ///< share of the pixels that the bounds of rounding do not explain

  bool failed() const { return result != Result::Passed && result != Result::Refused; }
};

/// Renders scenes and compares them. Kernels are kept until a scene of another kind.
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
