#pragma once
#include <cstdlib>
#include <string>

namespace laver::test {

/// The device that tests render on, as --device takes it, without blanks: LAVER_TEST_DEVICE, or the
/// first of the type CPU.
inline std::string testDevice() {
  const char* wanted = std::getenv("LAVER_TEST_DEVICE");
  return wanted != nullptr ? wanted : "cpu";
}

}  // namespace laver::test
