#pragma once
#include <string>

namespace laver {

/// The folder for files that may be deleted at any time: $XDG_CACHE_HOME/laver or ~/.cache/laver;
/// empty if neither variable holds an absolute path.
std::string cacheFolder();

}  // namespace laver
