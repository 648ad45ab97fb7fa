#pragma once
#include <volk.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "vulkan/handle.h"

namespace laver {

/// A file that keeps a driver's pipeline cache between runs. It is optional, so nothing here fails:
/// a file that is damaged, unreadable or of another driver counts as absent.
class CacheFile {
 public:
  /// One file per device and driver version. An empty `folder` means no file.
  CacheFile(const std::string& folder, const VkPhysicalDeviceProperties& device);

  const std::string& path() const { return path_; }

  /// The data that write() stored, if complete and for this device according to their header; else
  /// empty.
  std::vector<std::byte> read() const;
  /// Replaces the file and creates its folder. Data that hold no pipelines are not written.
  void write(std::span<const std::byte> data) const;

 private:
  VkPhysicalDeviceProperties device_;
  std::string path_;
};

/// The driver's compiled kernels, kept in a file between runs. Threads may share it. Mesa's drivers
/// have their own cache on disk, and lavapipe returns no data for this one. NVIDIA's driver has its
/// own, too, but by its README it is off for root, and so in many containers.
class PipelineCache {
 public:
  PipelineCache(VkPhysicalDevice physical, VkDevice device);
  /// Writes the file if the cache has changed.
  ~PipelineCache();
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  VkPipelineCache get() const { return cache_.get(); }  ///< VK_NULL_HANDLE if there is none

 private:
  VkDevice device_;
  CacheFile file_;
  std::vector<std::byte> read_;
  Handle<VkPipelineCache> cache_;
};

}  // namespace laver
