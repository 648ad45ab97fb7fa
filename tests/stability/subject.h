#pragma once
#include <memory>

#include "stability/twin/twin.h"
#include "support/test_device.h"
#include "trace/ray_tracer.h"

namespace laver::test {

/// One implementation under test: a traversal of the device, or a C++ twin.
class Subject {
 public:
  virtual ~Subject() = default;
  /// Nearest hits; each block of 64 rays has one origin.
  virtual std::vector<TestHit> closest(std::span<const TestRay> rays) = 0;
  virtual std::vector<std::uint32_t> visible(glm::vec3 light,
                                             std::span<const glm::vec3> points) = 0;

  std::string name;
  bool slow = false;  ///< not optimised: traces a share of the rays
  const Twin* twin = nullptr;
  double seconds = 0;  ///< spent in closest() and visible()
};

/// All traversals of the test device and all twins. `bvh` must outlive them.
std::vector<std::unique_ptr<Subject>> subjects(const Bvh& bvh);

/// A ray without an upper limit of t.
inline TestRay rayOf(glm::vec3 origin, glm::vec3 direction) {
  return {origin, 0.0F, direction, 1e37F};
}

}  // namespace laver::test
