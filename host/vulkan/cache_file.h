#pragma once
#include <volk.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace laver {

/// The folder for what may be lost: $XDG_CACHE_HOME/laver, ~/.cache/laver, or empty where neither
/// variable holds an absolute path.
std::string cacheFolder();

/// A file that keeps a driver's pipeline cache from run to run. It is worth nothing, so that it
/// never fails: what is damaged, of another driver or beyond reach is as good as none.
class CacheFile {
 public:
  /// One file for each device and version of its driver. No folder: no file.
  CacheFile(const std::string& folder, const VkPhysicalDeviceProperties& device);

  const std::string& path() const { return path_; }

  /// What write() was given, if every byte is there and its header names the device; else empty.
  std::vector<std::byte> read() const;
  /// Replaces the file, and makes its folder. Data that hold no pipelines are not written.
  void write(std::span<const std::byte> data) const;

 private:
  VkPhysicalDeviceProperties device_;
  std::string path_;
};

}  // namespace laver
