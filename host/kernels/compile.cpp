#include "kernels/compile.h"

#include <fmt/format.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#if __has_include(<glslang/Public/ResourceLimits.h>)
#include <glslang/Public/ResourceLimits.h>
#else
const TBuiltInResource* GetDefaultResources();  // glslang 12 exports it without a header
#endif

#include <regex>
#include <spirv-tools/optimizer.hpp>
#include <sstream>

#include "core/error.h"

namespace laver {
namespace {

/// Must change with every change of the passes below.
constexpr int kRecipe = 2;

/// lavapipe compiles a kernel that is already unrolled, inlined and cleaned up in 0.5 to 0.6 of the
/// time of the raw one. Loops are unrolled before inlining, while they hold calls instead of
/// arithmetic: spirv-opt's unrolling drops NoContraction, its inlining keeps it.
const std::vector<std::string> kUnroll = {"--merge-return",
                                          "--eliminate-local-single-block",
                                          "--eliminate-local-single-store",
                                          "--ssa-rewrite",
                                          "--ccp",
                                          "--eliminate-dead-branches",
                                          "--eliminate-dead-code-aggressive",
                                          "--loop-unroll"};

/// Takes a quarter of a second for a large kernel, once, and saves as much of the driver's time at
/// every start. The optimiser's own choice of passes saves twice that, but takes five times as
/// long.
const std::vector<std::string> kInline = {"--inline-entry-points-exhaustive",
                                          "--eliminate-local-single-block",
                                          "--eliminate-local-single-store",
                                          "--ssa-rewrite",
                                          "--ccp",
                                          "--eliminate-dead-branches",
                                          "--eliminate-dead-code-aggressive",
                                          "--cfg-cleanup"};

/// glslang's process-wide state.
struct Process {
  Process() { glslang::InitializeProcess(); }
  ~Process() { glslang::FinalizeProcess(); }
};

/// Converts "ERROR: mine.glsl:5: 'x' : undeclared identifier" to "mine.glsl:5: error: 'x' :
/// undeclared identifier" and drops the summaries.
[[noreturn]] void refuse(const std::string& log) {
  static const std::regex kError("ERROR: (.*):([0-9]+): (.*[^ ]) *");
  std::string lines;
  std::istringstream in(log);
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, kError) ||
        match[3].str().find("compilation terminated") != std::string::npos)
      continue;
    lines += fmt::format("{}{}:{}: error: {}", lines.empty() ? "" : "\n", match[1].str(),
                         match[2].str(), match[3].str());
    static const std::regex kProperty("'xml_(\\w+)' : undeclared identifier");
    const std::string message = match[3].str();
    if (std::smatch property; std::regex_match(message, property, kProperty))
      lines += fmt::format("; the element in the scene has no property \"{}\"", property[1].str());
  }
  throw Error(ExitCode::Scene, lines.empty() ? log : lines);
}

Spirv optimised(const Spirv& module, Effort effort) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  std::string problem;
  optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&,
                                   const char* message) { problem = message; });
  optimizer.RegisterPassesFromFlags(kUnroll);
  if (effort == Effort::Thorough)
    optimizer.RegisterPerformancePasses();
  else if (effort == Effort::Quick)
    optimizer.RegisterPassesFromFlags(kInline);
  Spirv result;
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  if (!optimizer.Run(module.data(), module.size(), &result, options))
    throw Error(ExitCode::Device, "internal error: the SPIR-V optimiser failed: " + problem);
  return result;
}

}  // namespace

Spirv compileGlsl(const std::string& text, Effort effort) {
  static const Process process;
  glslang::TShader shader(EShLangCompute);
  const char* strings[] = {text.c_str()};
  shader.setStrings(strings, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  if (!shader.parse(GetDefaultResources(), 460, false, messages)) refuse(shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages)) refuse(program.getInfoLog());
  Spirv module;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), module);
  return effort == Effort::None ? module : optimised(module, effort);
}

std::string compilerVersion() {
  const glslang::Version version = glslang::GetVersion();
  return fmt::format("laver {}, recipe {}, glslang {}.{}.{}, {}", LAVER_VERSION, kRecipe,
                     version.major, version.minor, version.patch,
                     spvSoftwareVersionDetailsString());
}

}  // namespace laver
