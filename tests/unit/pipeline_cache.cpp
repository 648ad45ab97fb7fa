#include "vulkan/pipeline_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/cache_folder.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

VkPhysicalDeviceProperties device() {
  VkPhysicalDeviceProperties properties{};
  properties.vendorID = 0x10de;
  properties.deviceID = 0x2331;
  properties.driverVersion = 7;
  for (std::uint8_t i = 0; i < VK_UUID_SIZE; ++i) properties.pipelineCacheUUID[i] = i;
  return properties;
}

/// A cache as the driver of that device would write it, with some pipelines.
Bytes pipelines(std::size_t count = 1000) {
  VkPipelineCacheHeaderVersionOne header{};
  header.headerSize = sizeof header;
  header.headerVersion = VK_PIPELINE_CACHE_HEADER_VERSION_ONE;
  header.vendorID = device().vendorID;
  header.deviceID = device().deviceID;
  std::memcpy(header.pipelineCacheUUID, device().pipelineCacheUUID, VK_UUID_SIZE);
  Bytes data(sizeof header + count);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::byte>(i * 7);
  std::memcpy(data.data(), &header, sizeof header);
  return data;
}

void replace(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

TEST(CacheFile, ReturnsWhatWasWritten) {
  const TemporaryFolder folder;
  const CacheFile file(folder.path("new/laver"), device());
  EXPECT_EQ(file.read(), Bytes());
  file.write(pipelines());
  EXPECT_EQ(CacheFile(folder.path("new/laver"), device()).read(), pipelines());
  file.write(pipelines(5000));
  EXPECT_EQ(file.read(), pipelines(5000));
  // The folder holds only that file, and only its owner has access.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path("new/laver")), {}), 1);
  EXPECT_EQ(fs::status(folder.path("new/laver")).permissions(), fs::perms::owner_all);
}

TEST(CacheFile, EveryFlippedBitIsDetected) {
  const TemporaryFolder folder;
  const CacheFile file(folder.path("laver"), device());
  file.write(pipelines());
  const std::string whole = contents(file.path());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 1 << i % 8);
    replace(file.path(), flipped);
    ASSERT_EQ(file.read(), Bytes()) << i;
  }
  replace(file.path(), whole);
  EXPECT_EQ(file.read(), pipelines());
}

TEST(CacheFile, ATruncatedOrTooLongFileIsDetected) {
  const TemporaryFolder folder;
  const CacheFile file(folder.path("laver"), device());
  file.write(pipelines(100));
  const std::string whole = contents(file.path());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    replace(file.path(), whole.substr(0, size));
    ASSERT_EQ(file.read(), Bytes()) << size;
  }
  replace(file.path(), whole + "x");
  EXPECT_EQ(file.read(), Bytes());
  fs::remove(file.path());
  fs::create_directory(file.path());
  EXPECT_EQ(file.read(), Bytes());
  file.write(pipelines());  // does nothing
}

TEST(CacheFile, OtherDriversHaveOtherFilesAndTheirDataAreRefused) {
  const TemporaryFolder folder;
  const CacheFile file(folder.path("laver"), device());
  file.write(pipelines());
  for (int what = 0; what < 4; ++what) {
    VkPhysicalDeviceProperties other = device();
    if (what == 0) other.vendorID = 1;
    if (what == 1) other.deviceID = 1;
    if (what == 2) other.driverVersion = 1;
    if (what == 3) other.pipelineCacheUUID[15] = 1;
    const CacheFile foreign(folder.path("laver"), other);
    EXPECT_NE(foreign.path(), file.path());
    EXPECT_EQ(foreign.read(), Bytes());
    // The header is checked, not only the name; the driver's version is only in the name.
    if (what == 2) continue;
    fs::copy_file(file.path(), foreign.path());
    EXPECT_EQ(foreign.read(), Bytes());
    fs::remove(foreign.path());
    foreign.write(pipelines());
    EXPECT_FALSE(fs::exists(foreign.path()));
  }
}

TEST(CacheFile, EmptyCachesAreNotWritten) {
  const TemporaryFolder folder;
  const CacheFile file(folder.path("laver"), device());
  file.write(pipelines(0));
  file.write({});
  EXPECT_EQ(folder.names().size(), 0U);
}

TEST(CacheFile, AnImpossibleFolderCountsAsNone) {
  const TemporaryFolder folder;
  replace(folder.path("file"), "no folder");
  for (const std::string& place : {std::string(), folder.path("file"), folder.path("file/laver"),
                                   std::string("/proc/laver")}) {
    const CacheFile file(place, device());
    file.write(pipelines());
    EXPECT_EQ(file.read(), Bytes()) << place;
  }
}

TEST(CacheFile, ItsFolderFollowsTheEnvironment) {
  const auto set = [](const char* name, const char* value) {
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  };
  const auto folder = [&](const char* cache, const char* home) {
    set("XDG_CACHE_HOME", cache);
    set("HOME", home);
    return cacheFolder();
  };
  const char* const oldCache = std::getenv("XDG_CACHE_HOME");
  const char* const oldHome = std::getenv("HOME");
  const std::string cache = oldCache == nullptr ? "" : oldCache, home = oldHome ? oldHome : "";
  EXPECT_EQ(folder("/c", "/h"), "/c/laver");
  EXPECT_EQ(folder(nullptr, "/h"), "/h/.cache/laver");
  EXPECT_EQ(folder("", "/h"), "/h/.cache/laver");
  EXPECT_EQ(folder("relative", "/h"), "/h/.cache/laver");  // by the XDG specification
  EXPECT_EQ(folder(nullptr, nullptr), "");
  EXPECT_EQ(folder(nullptr, "relative"), "");
  set("XDG_CACHE_HOME", oldCache == nullptr ? nullptr : cache.c_str());
  set("HOME", oldHome == nullptr ? nullptr : home.c_str());
}

}  // namespace
}  // namespace laver::test
