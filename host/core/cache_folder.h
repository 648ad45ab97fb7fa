#pragma once
#include <string>

namespace laver {

/// The folder for files that may be lost: $XDG_CACHE_HOME/laver, ~/.cache/laver, or empty where
/// neither variable holds an absolute path.
std::string cacheFolder();

}  // namespace laver
