#pragma once
#include <functional>
#include <string>

#include "render/renderer.h"
#include "scene/test_file.h"

namespace laver {

/// How to run a test file.
struct TestOptions {
  VulkanOptions vulkan;
  bool reference = false;  ///< in double precision on the CPU
  unsigned threads = 0;    ///< of the reference
};

struct TestOutcome {
  std::size_t passed = 0, tests = 0;
};

/// Runs all tests and prints what each found, as Nori does. Throws Error(Device) and, for a user's
/// code in the reference, Error(Scene).
TestOutcome runTests(const TestFile& file, const TestOptions& options,
                     const std::function<void(const std::string&)>& print);

}  // namespace laver
