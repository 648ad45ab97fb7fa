#include "vulkan/device_info.h"

#include <gtest/gtest.h>

#include <vector>

#include "commands/commands.h"
#include "core/error.h"

namespace laver::test {
namespace {

DeviceInfo device(const char* name, VkPhysicalDeviceType type) {
  DeviceInfo info;
  info.name = name;
  info.driver = "made-up 1.2";
  info.type = type;
  info.apiVersion = VK_MAKE_API_VERSION(0, 1, 3, 230);
  info.computeFamily = 0;
  info.subgroupSize = 32;
  info.maxAllocation = std::uint64_t{2} << 30;
  info.limits.maxStorageBufferRange = 128U << 20;
  info.limits.maxTexelBufferElements = 65536;
  for (const std::size_t i : {0U, 1U, 2U})
    info.limits.maxComputeWorkGroupCount[i] = 65535 - static_cast<std::uint32_t>(i);
  info.memory.memoryHeapCount = 2;
  info.memory.memoryHeaps[0] = {std::uint64_t{8} << 30, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
  info.memory.memoryHeaps[1] = {std::uint64_t{256} << 20, 0};
  return info;
}

std::vector<DeviceInfo> several() {
  std::vector<DeviceInfo> devices = {device("llvmpipe", VK_PHYSICAL_DEVICE_TYPE_CPU),
                                     device("Old One", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
                                     device("Iris", VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU),
                                     device("Blit", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
                                     device("Radeon A", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
                                     device("Radeon B", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU)};
  devices[1].apiVersion = VK_MAKE_API_VERSION(0, 1, 0, 65);
  devices[1].subgroupSize = 0;
  devices[1].maxAllocation = 0;
  devices[3].computeFamily = -1;
  return devices;
}

TEST(ChooseDevice, TakesTheBestUsableKind) {
  auto devices = several();
  EXPECT_EQ(chooseDevice(devices, ""), 4u);
  devices.resize(4);
  EXPECT_EQ(chooseDevice(devices, ""), 2u);
  devices.resize(2);
  EXPECT_EQ(chooseDevice(devices, ""), 0u);
}

TEST(ChooseDevice, TakesIndexNameOrCpu) {
  const auto devices = several();
  EXPECT_EQ(chooseDevice(devices, "2"), 2u);
  EXPECT_EQ(chooseDevice(devices, "rAdEoN b"), 5u);
  EXPECT_EQ(chooseDevice(devices, "radeon"), 4u);
  EXPECT_EQ(chooseDevice(devices, "CPU"), 0u);
}

TEST(ChooseDevice, ExplainsWhyThereIsNone) {
  const auto refusal = [](const std::vector<DeviceInfo>& devices, const char* wanted) {
    try {
      chooseDevice(devices, wanted);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Device);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  auto devices = several();
  devices = {devices[1], devices[3]};
  EXPECT_EQ(
      refusal(devices, ""),
      "no usable Vulkan device; there are 0: Old One (discrete GPU, Vulkan 1.0.65): cannot be "
      "used, its Vulkan is older than 1.1, 1: Blit (discrete GPU, Vulkan 1.3.230): cannot be "
      "used, it has no compute queue");
  EXPECT_EQ(refusal(devices, "9").rfind("no usable Vulkan device matches \"9\"; there are ", 0),
            0u);
  EXPECT_EQ(refusal({}, ""), "no Vulkan device found (is a driver there?)");
}

TEST(DescribeDevice, ListsTheLimitsThatLaverDependsOn) {
  EXPECT_EQ(describe(several()[4], 4, true),
            "4: Radeon A (default)\n"
            "   type                      discrete GPU\n"
            "   driver                    made-up 1.2\n"
            "   Vulkan                    1.3.230\n"
            "   subgroup size             32\n"
            "   traversal                 lane\n"
            "   maxStorageBufferRange     134217728 (128 MiB)\n"
            "   maxTexelBufferElements    65536\n"
            "   maxMemoryAllocationSize   2147483648 (2048 MiB)\n"
            "   maxComputeWorkGroupCount  65535 x 65534 x 65533\n"
            "   memory heaps              8192 MiB device-local, 256 MiB\n");
}

TEST(DescribeDevice, NamesTheTraversal) {
  DeviceInfo info = several()[0];
  const auto runs = [&](const char* name) {
    return describe(info, 0, false).find(std::string("traversal                 ") + name) !=
           std::string::npos;
  };
  info.subgroupSize = 8;
  EXPECT_TRUE(runs("lane"));
  info.shuffles = true;
  EXPECT_TRUE(runs("lane"));
  info.longs = true;
  EXPECT_TRUE(runs("packet"));
  info.subgroupSize = 32;
  EXPECT_TRUE(runs("lane"));
}

TEST(DescribeDevice, ExplainsWhyItCannotBeUsed) {
  EXPECT_EQ(describe(several()[1], 1, false),
            "1: Old One\n"
            "   cannot be used            its Vulkan is older than 1.1\n"
            "   type                      discrete GPU\n"
            "   driver                    made-up 1.2\n"
            "   Vulkan                    1.0.65\n"
            "   maxStorageBufferRange     134217728 (128 MiB)\n"
            "   maxTexelBufferElements    65536\n"
            "   maxComputeWorkGroupCount  65535 x 65534 x 65533\n"
            "   memory heaps              8192 MiB device-local, 256 MiB\n");
  EXPECT_NE(describe(several()[3], 3, false).find("it has no compute queue"), std::string::npos);
}

}  // namespace
}  // namespace laver::test
