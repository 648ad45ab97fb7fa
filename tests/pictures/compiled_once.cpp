// The driver compiles each kernel once, whatever the sizes of scene and film.
#include "pictures/command_line.h"

namespace laver::test {
namespace {

TEST_F(CommandLine, KernelsAreCompiledOnceForAllSizes) {
  write("test.xml", kFirstScene);
  const auto cached = [&] {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache"))
      if (entry.is_regular_file()) names.insert(entry.path().filename());
    return names;
  };
  std::set<std::string> first;
  // The buffers of 64 x 64 and 16 x 16 samples have special sizes: multiples of 65536 and of 256
  // bytes, powers of two.
  for (const char* size : {"33x35", "64x64", "16x16", "256x16"}) {
    const Outcome run =
        laver("test.xml --device $device -q --spp 1 --traversal packet --size " + std::string(size),
              "MESA_SHADER_CACHE_DIR=cache");
    ASSERT_EQ(run.code, 0) << run.err;
    if (first.empty()) first = cached();
    EXPECT_GE(first.size(), 2U);  // the driver caches both kernels
    EXPECT_EQ(cached(), first) << size;
  }
}

}  // namespace
}  // namespace laver::test
