// What the compiled kernels let a driver do: contract, drop NaN, compute with 64 bits.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "stability/record.h"
#include "stability/spirv_lint.h"

namespace laver::test {
namespace {

std::string disassembly(const std::string& name) {
  const std::string command =
      std::string(LAVER_SPIRV_DIS) + " --no-color '" + LAVER_SPIRV_DIR + "/" + name + ".spv'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr)
    text += part.data();
  EXPECT_FALSE(text.empty()) << command;
  return text;
}

std::string without(std::string text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at))
    text.erase(at, word.size());
  return text;
}

/// The kernels of laver itself, as the build names them: shaders/NAME.comp becomes NAME_*.spv.
std::vector<std::string> productionKernels() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(LAVER_SPIRV_DIR)) {
    const std::string name = file.path().stem();
    if (file.path().extension() != ".spv" || name.ends_with(".embedded")) continue;
    for (const auto& source :
         std::filesystem::directory_iterator(std::string(LAVER_SOURCE_DIR) + "/shaders"))
      if (source.path().extension() == ".comp" &&
          name.starts_with(source.path().stem().string() + "_"))
        names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

LAVER_STABILITY(Spirv, "SPIR-V: NoContraction, no min or max of NaN, no arithmetic of 64 bits") {
  const auto kernels = productionKernels();
  EXPECT_GE(kernels.size(), 40U);
  for (const std::string& name : kernels) {
    const std::string text = disassembly(name);
    const KernelCounts counts = countOf(text);
    const bool packet = name.find("_packet") != std::string::npos;
    const auto faults = lint(counts, packet);
    // A function that was renamed would escape the list.
    if (name.rfind("gather", 0) != 0) {
      for (const char* needed : {"differenceOfProducts", "edgesOf", "depthOf", "shearOf", "pointAt",
                                 "filmPosition", "insidePixel", "cameraDirection"}) {
        const bool drawn = name.rfind("centres", 0) != 0 || needed != std::string("filmPosition");
        EXPECT_EQ(counts.functions.count(needed), drawn ? 1U : 0U) << name << ", " << needed;
      }
    }
    for (const std::string& fault : faults) ADD_FAILURE() << name << ": " << fault;

    // What is embedded holds precise functions more often than others, inlined and unrolled. Where
    // one of the two drops the decoration, its share falls: to a half or a third, when tried.
    EXPECT_GE(decoratedShare(countOf(disassembly(name + ".embedded"))), decoratedShare(counts))
        << name;

    // The same kernel without `precise`.
    const std::string plain = without(text, "NoContraction");
    record.add({name + ".spv", "naive: no precise",
                static_cast<std::uint64_t>(preciseArithmetic(counts).arithmetic),
                static_cast<double>(lint(countOf(plain), packet).size()),
                static_cast<double>(faults.size()), 0.0, "faults"});
  }
}

TEST(SpirvLint, FindsEachKindOfFault) {
  const std::string good =
      "OpName %1 \"expected(f1;\"\nOpName %2 \"depthOf(f1;\"\nOpDecorate %3 NoContraction\n"
      "%f = OpTypeFloat 32\n%1 = OpFunction %f None %t\n%9 = OpFMul %f %a %b\n";
  EXPECT_TRUE(lint(countOf(good)).empty());
  EXPECT_EQ(lint(countOf(good + "%8 = OpExtInst %f %1 FMin %a %b\n")).size(), 1U);
  EXPECT_EQ(lint(countOf(good + "%d = OpTypeFloat 64\n"), true).size(), 1U);
  const std::string longs = good + "%l = OpTypeInt 64 0\n%v = OpTypeVector %l 2\n";
  EXPECT_EQ(lint(countOf(longs)).size(), 1U);
  const std::string passed = longs + "%x = OpBitcast %l %y\n%z = OpCompositeConstruct %v %x %x\n";
  EXPECT_TRUE(lint(countOf(passed), true).empty());
  EXPECT_EQ(lint(countOf(passed + "%s = OpIAdd %l %x %x\n"), true).size(), 1U);
  EXPECT_EQ(lint(countOf(passed + "%s = OpShiftLeftLogical %v %z %z\n"), true).size(), 1U);
  const std::string chosen =
      "OpSelectionMerge %m None\nOpBranchConditional %c %t %m\n%t = OpLabel\n";
  const std::string shuffle = "%u = OpGroupNonUniformShuffle %f %s %9 %i\n";
  const std::string after = "OpBranch %m\n%m = OpLabel\n";
  EXPECT_TRUE(lint(countOf(good + shuffle)).empty());
  EXPECT_TRUE(lint(countOf(good + chosen + after + shuffle)).empty());
  EXPECT_TRUE(
      lint(countOf("%c = OpSpecConstantTrue %b\n" + good + chosen + shuffle + after)).empty());
  EXPECT_EQ(lint(countOf(good + chosen + shuffle + after)).size(), 1U);
  const std::string called = good + chosen + "%v = OpFunctionCall %f %5 %9\n" + after;
  const std::string callee = "OpName %5 \"lent(f1;\"\n%5 = OpFunction %f None %t\n";
  EXPECT_TRUE(lint(countOf(called + callee)).empty());
  EXPECT_EQ(lint(countOf(called + callee + shuffle)).size(), 1U);
  EXPECT_EQ(lint(countOf(good + "%2 = OpFunction %f None %t\n%3 = OpFMul %f %a %b\n")).size(), 1U);
}

}  // namespace
}  // namespace laver::test
