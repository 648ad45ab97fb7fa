#include "vulkan/pipeline_cache.h"

#include <new>

namespace laver {
namespace {

VkPhysicalDeviceProperties propertiesOf(VkPhysicalDevice physical) {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  return properties;
}

VkPipelineCache create(VkDevice device, std::span<const std::byte> data) {
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  VkPipelineCache cache = VK_NULL_HANDLE;
  return vkCreatePipelineCache(device, &info, nullptr, &cache) == VK_SUCCESS ? cache
                                                                             : VK_NULL_HANDLE;
}

std::vector<std::byte> contents(VkDevice device, VkPipelineCache cache) {
  std::size_t size = 0;
  if (vkGetPipelineCacheData(device, cache, &size, nullptr) != VK_SUCCESS) return {};
  std::vector<std::byte> data(size);
  if (vkGetPipelineCacheData(device, cache, &size, data.data()) != VK_SUCCESS) return {};
  data.resize(size);
  return data;
}

}  // namespace

PipelineCache::PipelineCache(VkPhysicalDevice physical, VkDevice device)
    : device_(device), file_(cacheFolder(), propertiesOf(physical)), read_(file_.read()) {
  VkPipelineCache cache = create(device, read_);
  if (cache == VK_NULL_HANDLE) cache = create(device, {});
  if (cache != VK_NULL_HANDLE) cache_ = {device, cache, vkDestroyPipelineCache};
}

PipelineCache::~PipelineCache() try {
  if (cache_.get() == VK_NULL_HANDLE) return;
  const std::vector<std::byte> data = contents(device_, cache_.get());
  if (data != read_) file_.write(data);
} catch (const std::bad_alloc&) {
}

}  // namespace laver
