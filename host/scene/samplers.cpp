#include "scene/samplers.h"

#include <cmath>
#include <limits>

namespace laver {
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

// Uniform, each by itself.
const SamplerRow independent{.name = "independent",
                             .object = "Independent",
                             .properties = properties(),
                             .stream = true,
                             .adaptive = true};

// Uniform, one in each stratum.
const SamplerRow stratified{
    .name = "stratified", .object = "Stratified", .properties = properties(), .strata = true};

// A (0,2)-sequence, Owen-scrambled by pixel.
const SamplerRow sobol{.name = "sobol",
                       .object = "Sobol",
                       .properties = properties(),
                       .countFree = true,
                       .adaptive = true};

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
