#pragma once
#include <volk.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "vulkan/handle.h"

namespace laver {

/// A file that keeps a driver's pipeline cache from run to run. It may be lost, so nothing here
/// fails: a file that is damaged, of another driver or out of reach counts as none.
class CacheFile {
 public:
  /// One file per device and version of its driver. No folder: no file.
  CacheFile(const std::string& folder, const VkPhysicalDeviceProperties& device);

  const std::string& path() const { return path_; }

  /// The data of write(), if complete and of this device by their header; else empty.
  std::vector<std::byte> read() const;
  /// Replaces the file, and makes its folder. Data that hold no pipelines are not written.
  void write(std::span<const std::byte> data) const;

 private:
  VkPhysicalDeviceProperties device_;
  std::string path_;
};

/// The driver's compiled kernels, kept in a file from run to run. Several threads may compile with
/// it. Mesa's drivers have a cache of their own on disk, and lavapipe gives no data for this one.
/// NVIDIA's driver has one too, but by its README it is off for root, and so in many containers.
class PipelineCache {
 public:
  PipelineCache(VkPhysicalDevice physical, VkDevice device);
  /// Writes the file if there is anything new.
  ~PipelineCache();
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  VkPipelineCache get() const { return cache_.get(); }  ///< VK_NULL_HANDLE where there is none

 private:
  VkDevice device_;
  CacheFile file_;
  std::vector<std::byte> read_;
  Handle<VkPipelineCache> cache_;
};

}  // namespace laver
