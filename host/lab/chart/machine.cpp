#include "lab/chart/machine.h"

#include <fmt/format.h>

#include <ctime>
#include <fstream>

#include "core/parallel.h"

namespace laver::chart {

std::string machine() {
  std::ifstream in("/proc/cpuinfo");
  std::string name = "an unknown processor";
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0) {
      name = line.substr(line.find(':') + 2);
      break;
    }
  return fmt::format("{}, {} threads", name, threadCount(0));
}

std::string compiler() {
#ifdef __clang__
  return __VERSION__;  // "Debian Clang 14.0.6"
#else
  return "g++ " __VERSION__;
#endif
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace laver::chart
