#pragma once
#include "vulkan/cache_file.h"
#include "vulkan/handle.h"

namespace laver {

/// The driver's compiled kernels, kept in a file from run to run. Several threads may compile with
/// it. lavapipe keeps none of them here and has a cache of its own.
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
