#include "vulkan/pipeline_cache.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

#include "core/atomic_file.h"
#include "core/cache_folder.h"
#include "core/error.h"
#include "core/hash.h"

namespace laver {
namespace {

namespace fs = std::filesystem;

/// Start of the file. Numbers are in native byte order, since a file is used on one machine only.
struct Preface {
  char magic[8] = {'l', 'a', 'v', 'e', 'r', 'p', 'c', '1'};
  std::uint64_t size = 0;  ///< of the data that follow, bytes
  std::uint64_t checksum = 0;
};
static_assert(sizeof(Preface) == 24);

/// Larger caches are not written, and not read.
constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

/// Checks the data's header (Vulkan, "Pipeline Cache Header"), which drivers need not do.
bool isOf(const VkPhysicalDeviceProperties& device, std::span<const std::byte> data) {
  VkPipelineCacheHeaderVersionOne header;
  if (data.size() < sizeof header) return false;
  std::memcpy(&header, data.data(), sizeof header);
  return header.headerSize >= sizeof header &&
         header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
         header.vendorID == device.vendorID && header.deviceID == device.deviceID &&
         std::memcmp(header.pipelineCacheUUID, device.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

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

CacheFile::CacheFile(const std::string& folder, const VkPhysicalDeviceProperties& device)
    : device_(device) {
  if (folder.empty()) return;
  path_ = fmt::format("{}/{:08x}-{:08x}-{:08x}-", folder, device.vendorID, device.deviceID,
                      device.driverVersion);
  for (const std::uint8_t byte : device.pipelineCacheUUID) path_ += fmt::format("{:02x}", byte);
  path_ += ".pipelines";
}

std::vector<std::byte> CacheFile::read() const {
  std::error_code error;
  if (path_.empty() || !fs::is_regular_file(path_, error)) return {};
  std::ifstream file(path_, std::ios::binary);
  const Preface wanted;
  Preface preface;
  if (!file.read(reinterpret_cast<char*>(&preface), sizeof preface) ||
      std::memcmp(preface.magic, wanted.magic, sizeof wanted.magic) != 0 ||
      preface.size > kMaxBytes || fs::file_size(path_, error) != sizeof preface + preface.size)
    return {};
  std::vector<std::byte> data(preface.size);
  if (!file.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(data.size())) ||
      hashOf(data) != preface.checksum || !isOf(device_, data))
    return {};
  return data;
}

void CacheFile::write(std::span<const std::byte> data) const {
  if (path_.empty() || data.size() > kMaxBytes || !isOf(device_, data) ||
      data.size() <= sizeof(VkPipelineCacheHeaderVersionOne))
    return;
  const fs::path folder = fs::path(path_).parent_path();
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  static_cast<void>(::mkdir(folder.c_str(), 0700));  // may be there
  Preface preface;
  preface.size = data.size();
  preface.checksum = hashOf(data);
  try {
    AtomicFile file(path_);
    file.write(std::as_bytes(std::span(&preface, 1)));
    file.write(data);
    file.commit();
  } catch (const Error&) {
  }
}

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
