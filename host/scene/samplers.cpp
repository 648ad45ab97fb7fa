#include "scene/samplers.h"

#include <cmath>
#include <limits>

namespace laver {

// host/reference/sampler/NAME.cpp
namespace reference {
namespace independent {
glm::vec2 position(const Camera& camera, const Sampler& sampler, const PixelSample& at);
glm::vec2 pair(const Camera& camera, const Sampler& sampler, const PixelSample& at,
               std::uint32_t dimension);
}  // namespace independent
namespace stratified {
glm::vec2 position(const Camera& camera, const Sampler& sampler, const PixelSample& at);
glm::vec2 pair(const Camera& camera, const Sampler& sampler, const PixelSample& at,
               std::uint32_t dimension);
}  // namespace stratified
namespace sobol {
glm::vec2 position(const Camera& camera, const Sampler& sampler, const PixelSample& at);
glm::vec2 pair(const Camera& camera, const Sampler& sampler, const PixelSample& at,
               std::uint32_t dimension);
}  // namespace sobol
}  // namespace reference

namespace {

std::vector<PropertyRow> properties() {
  return {{.name = "sampleCount",
           .type = PropertyType::Integer,
           .start = std::int64_t{Sampler{}.sampleCount},
           .range = fromTo(1, std::numeric_limits<std::uint32_t>::max()),
           .meaning = "samples per pixel"},
          {.name = "seed",
           .type = PropertyType::Integer,
           .start = Sampler{}.seed,
           .meaning = "another seed gives other samples"}};
}

}  // namespace

namespace samplers {

// Independent uniform samples.
const SamplerRow independent{.name = "independent",
                             .object = "Independent",
                             .properties = properties(),
                             .stream = true,
                             .adaptive = true,
                             .position = reference::independent::position,
                             .pair = reference::independent::pair};

// One uniform sample in each stratum.
const SamplerRow stratified{.name = "stratified",
                            .object = "Stratified",
                            .properties = properties(),
                            .strata = true,
                            .position = reference::stratified::position,
                            .pair = reference::stratified::pair};

// A (0,2)-sequence, Owen-scrambled by pixel.
const SamplerRow sobol{.name = "sobol",
                       .object = "Sobol",
                       .properties = properties(),
                       .countFree = true,
                       .adaptive = true,
                       .position = reference::sobol::position,
                       .pair = reference::sobol::pair};

}  // namespace samplers

const Rows<SamplerRow>& samplerRows() {
  using namespace samplers;
  static const Rows<SamplerRow> rows = {&independent, &stratified, &sobol};
  return rows;
}

glm::uvec2 strataOf(std::uint32_t sampleCount) {
  auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(sampleCount)));
  while (sampleCount % columns != 0) --columns;
  return {columns, sampleCount / columns};
}

}  // namespace laver
