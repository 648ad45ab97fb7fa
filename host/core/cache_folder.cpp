#include "core/cache_folder.h"

#include <cstdlib>

namespace laver {
namespace {

std::string absolute(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && value[0] == '/' ? value : "";
}

}  // namespace

std::string cacheFolder() {
  if (const std::string base = absolute("XDG_CACHE_HOME"); !base.empty()) return base + "/laver";
  const std::string home = absolute("HOME");
  return home.empty() ? "" : home + "/.cache/laver";
}

}  // namespace laver
