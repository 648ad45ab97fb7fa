// Sampled directions of BSDFs on the device, against the reference's BSDFs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "kernels/compose.h"
#include "kernels/modules.h"
#include "reference/bsdf.h"
#include "render/device_scene.h"
#include "support/test_device.h"
#include "trace/ray_tracer.h"
#include "vulkan/bindings.h"
#include "vulkan/kernel.h"

namespace laver::test {
namespace {

struct Drawn {
  glm::vec4 woAndPdf, weight;
};

/// Directions on the upper and the lower side, with two random numbers for each.
std::vector<std::array<glm::vec4, 2>> inputs() {
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> number(0.0F, 1.0F);
  std::vector<std::array<glm::vec4, 2>> all(4096);
  for (auto& [wi, more] : all) {
    glm::vec3 d;
    do d = glm::vec3(number(engine), number(engine), number(engine)) * 2.0F - 1.0F;
    while (glm::dot(d, d) > 1.0F || std::abs(d.z) < 0.05F);
    wi = glm::vec4(glm::normalize(d), number(engine));
    more = glm::vec4(number(engine), 0.0F, 0.0F, 0.0F);
  }
  return all;
}

std::vector<Drawn> drawn(const Bsdf& bsdf, std::span<const std::array<glm::vec4, 2>> input) {
  const Instance instance(false);
  const Device device(choosePhysicalDevice(instance, testDevice()));
  const auto production = bindingTypes();
  std::vector<VkDescriptorType> types(production.begin(), production.end());
  types.push_back(VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
  types.push_back(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
  const Bindings bindings(device, types);
  const Buffer texels(device, "input", Buffer::Use::Texels, input.size_bytes());
  texels.upload(std::as_bytes(input));
  const auto view = texels.texelView(VK_FORMAT_R32G32B32A32_SFLOAT);
  bindings.bind(shared::BINDINGS, view.get());
  std::vector<Drawn> result(input.size());
  const Buffer output(device, "output", Buffer::Use::Storage, result.size() * sizeof(Drawn));
  bindings.bind(shared::BINDINGS + 1, output);

  const std::string name = bsdf.row->name;
  TraceKey key;
  key.bsdfs = {name};
  const std::string text = fmt::format(
      "#include \"texture/plain.glsl\"\n#include \"bsdf/material.glsl\"\n"
      "#include \"bsdf/{0}.glsl\"\n#define SAMPLE {0}Sample\n#define PDF {0}Pdf\n{1}",
      name, testText("sample_bsdf.glsl"));
  const Kernel kernel(device, bindings, moduleOf(composeWith(key, text)).words,
                      sizeof(shared::Pass));
  shared::Pass pass{};
  pass.region.x = static_cast<std::uint32_t>(input.size());
  const std::vector<double> numbers = numbersOf(bsdf);
  for (std::size_t i = 0; i < numbers.size() && i < 2; ++i)
    pass.core[static_cast<int>(i)] = std::bit_cast<std::uint32_t>(static_cast<float>(numbers[i]));
  device.run([&](VkCommandBuffer commands) {
    kernel.dispatch(commands, bindings, std::as_bytes(std::span(&pass, 1)),
                    {(pass.region.x + 63) / 64, 1, 1});
  });
  output.download(std::as_writable_bytes(std::span(result)));
  return result;
}

class SampleBsdf : public testing::TestWithParam<const BsdfRow*> {};

TEST_P(SampleBsdf, OnTheDeviceEqualsTheReference) {
  Bsdf bsdf;
  bsdf.row = GetParam();
  bsdf.albedo = {0.25, 0.5, 0.75};
  const auto input = inputs();
  const auto output = drawn(bsdf, input);
  const reference::BsdfPoint point{bsdf, bsdf.albedo, {0.0, 0.0, 1.0}};
  std::size_t other = 0;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const glm::dvec3 wi(input[i][0]);
    const reference::BsdfSample truth =
        bsdf.row->sample(point, wi, {static_cast<double>(input[i][0].w), input[i][1].x});
    const glm::dvec3 wo(output[i].woAndPdf);
    // Some tens of roundings of numbers of about 1: 2^-24 each. A choice may differ if a random
    // number equals a probability up to rounding.
    if (glm::length(wo - truth.wo) > 1e-5) {
      ++other;
      continue;
    }
    EXPECT_LT(glm::length(glm::dvec3(output[i].weight) - truth.weight), 1e-5) << i;
    EXPECT_NEAR(static_cast<double>(output[i].woAndPdf.w), bsdf.row->pdf(point, wi, truth.wo), 1e-5)
        << i;
  }
  EXPECT_LE(other, 2U);
}

INSTANTIATE_TEST_SUITE_P(Rows, SampleBsdf, testing::ValuesIn(bsdfRows()),
                         [](const auto& instance) { return std::string(instance.param->name); });

}  // namespace
}  // namespace laver::test
