// Film positions of samples on the device, against the reference, to the bit.
#include <gtest/gtest.h>

#include <bit>

#include "kernels/compose.h"
#include "kernels/modules.h"
#include "pictures/harness.h"
#include "reference/sampler.h"
#include "render/pack_parts.h"
#include "trace/ray_tracer.h"
#include "vulkan/bindings.h"
#include "vulkan/kernel.h"

namespace laver::test {
namespace {

/// Film positions and second pairs of samples first .. first + count - 1 of the pixels of `region`
/// (x, y, width, height), in the order of tests/trace/sample_positions.glsl.
std::vector<glm::vec4> devicePositions(const Device& device, const Scene& scene, glm::uvec4 region,
                                       std::uint32_t first, std::uint32_t count) {
  TraceKey key;
  key.sampler = scene.sampler.row->name;
  if (scene.sampler.row->stream) key.jumpLevels = jumpLevels(scene.sampler.sampleCount);
  Packed data;
  packSampler(scene, key.jumpLevels, data);
  data.params.filmSize = {static_cast<std::uint32_t>(scene.camera.width),
                          static_cast<std::uint32_t>(scene.camera.height)};
  data.jumps.resize(data.jumps.size() + 3);  // only `independent` reads them

  std::array<VkDescriptorType, shared::BINDINGS + 1> types;
  types.fill(VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
  types[shared::BIND_PARAMS] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  types[shared::BINDINGS] = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  Bindings bindings(device, types);
  Buffer params(device, "parameters", Buffer::Use::Uniform, sizeof data.params);
  params.upload(std::as_bytes(std::span(&data.params, 1)));
  bindings.bind(shared::BIND_PARAMS, params);
  Buffer jumps(device, "tables", Buffer::Use::Texels, data.jumps.size() * sizeof data.jumps[0]);
  jumps.upload(std::as_bytes(std::span(data.jumps)));
  const auto view = jumps.texelView(VK_FORMAT_R32G32B32A32_UINT);
  bindings.bind(shared::BIND_JUMPS, view.get());
  std::vector<glm::vec4> positions(std::size_t{region.z} * region.w * count);
  const Buffer output(device, "positions", Buffer::Use::Storage,
                      (positions.size() + 63) / 64 * 64 * sizeof positions[0]);
  bindings.bind(shared::BINDINGS, output);

  const std::string text =
      "#include \"sampler/" + key.sampler + ".glsl\"\n" + testText("sample_positions.glsl");
  const Kernel kernel(device, bindings, moduleOf(composeWith(key, text)).words,
                      sizeof(shared::Pass));
  shared::Pass pass{};
  pass.region = region;
  pass.firstSample = first;
  pass.sampleCount = count;
  pass.core.x = 1;
  device.run([&](VkCommandBuffer commands) {
    kernel.dispatch(commands, bindings, std::as_bytes(std::span(&pass, 1)),
                    {static_cast<std::uint32_t>((positions.size() + 63) / 64), 1, 1});
  });
  output.download(std::as_writable_bytes(std::span(positions)));
  return positions;
}

struct Film {
  const SamplerRow* kind;
  std::uint32_t samples;
  std::int64_t seed;
  int width, height;
  glm::uvec4 region;
  std::uint32_t first;
};

class SamplePositions : public testing::TestWithParam<Film> {};

TEST_P(SamplePositions, OnTheDeviceEqualTheReferences) {
  const Film& film = GetParam();
  const Instance instance(false);
  const Device device(choosePhysicalDevice(instance, testDevice()));
  Scene scene;
  scene.camera.width = film.width;
  scene.camera.height = film.height;
  scene.sampler = {film.samples, film.seed, film.kind};
  const std::uint32_t count = std::min(film.samples - film.first, 64U);
  const auto positions = devicePositions(device, scene, film.region, film.first, count);
  std::size_t n = 0;
  for (std::uint32_t y = 0; y < film.region.w; ++y)
    for (std::uint32_t x = 0; x < film.region.z; ++x)
      for (std::uint32_t s = 0; s < count; ++s, ++n) {
        const glm::uvec2 pixel(film.region.x + x, film.region.y + y);
        const glm::vec2 wanted =
            reference::samplePosition(scene.camera, scene.sampler, static_cast<int>(pixel.x),
                                      static_cast<int>(pixel.y), film.first + s);
        const reference::Numbers numbers(
            scene.camera, scene.sampler,
            {static_cast<int>(pixel.x), static_cast<int>(pixel.y), film.first + s});
        const glm::vec2 aperture(numbers.pair(1));
        ASSERT_EQ(positions[n], glm::vec4(wanted, aperture))
            << pixel.x << ' ' << pixel.y << ' ' << s;
        // `independent` may be rounded up to the next pixel's border.
        ASSERT_GE(positions[n].x, static_cast<float>(pixel.x));
        ASSERT_LE(positions[n].x - static_cast<float>(pixel.x), 1.0F);
        if (film.kind == &samplers::independent) continue;
        ASSERT_GT(positions[n].y, static_cast<float>(pixel.y));
        ASSERT_LT(positions[n].x, static_cast<float>(pixel.x + 1));
        ASSERT_LT(positions[n].y, static_cast<float>(pixel.y + 1));
      }
}

std::vector<Film> films() {
  std::vector<Film> list;
  for (const SamplerRow* kind : {&samplers::independent, &samplers::stratified, &samplers::sobol}) {
    list.push_back({kind, 1, 0, 1, 1, {0, 0, 1, 1}, 0});
    list.push_back({kind, 16, 0, 70, 45, {0, 0, 70, 45}, 0});
    list.push_back({kind, 7, -5, 70, 45, {31, 30, 39, 15}, 0});
    list.push_back({kind, 60, std::int64_t{1} << 40, 16384, 16384, {16300, 16350, 84, 34}, 0});
    list.push_back({kind, 1U << 20, 3, 768, 768, {700, 0, 68, 9}, (1U << 20) - 64});
    list.push_back({kind, 4294967291U, 3, 768, 768, {0, 760, 3, 2}, 4294967291U - 64});
  }
  return list;
}
INSTANTIATE_TEST_SUITE_P(Films, SamplePositions, testing::ValuesIn(films()));

}  // namespace
}  // namespace laver::test
