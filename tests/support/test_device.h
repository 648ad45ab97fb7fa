#pragma once
#include <cstdlib>
#include <string>

namespace laver::test {

/// The device for tests, a value of --device without blanks: LAVER_TEST_DEVICE, or the first device
/// of type CPU.
inline std::string testDevice() {
  const char* wanted = std::getenv("LAVER_TEST_DEVICE");
  return wanted != nullptr ? wanted : "cpu";
}

}  // namespace laver::test
