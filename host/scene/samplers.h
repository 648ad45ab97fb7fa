#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/property.h"
#include "scene/rows.h"

namespace laver {

struct Camera;
struct Sampler;

namespace reference {
struct PixelSample;
}

/// A sampler. Its kernel's part is shaders/sampler/NAME.glsl, its twin
/// host/reference/sampler/NAME.cpp.
struct SamplerRow {
  const char* name;                      ///< in scenes and on the command line
  std::vector<const char*> spellings{};  ///< other names in scenes
  const char* object = "";               ///< in the dump
  std::vector<PropertyRow> properties{};
  bool stream = false;     ///< Nori's generator, one for each block of 32 x 32 pixels
  bool strata = false;     ///< one sample in each of strataOf(sampleCount)
  bool countFree = false;  ///< the sample count changes no sample
  bool adaptive = false;   ///< the first samples of a pixel cover it evenly by themselves
  /// Film position in pixels.
  glm::vec2 (*position)(const Camera& camera, const Sampler& sampler,
                        const reference::PixelSample& at) = nullptr;
  /// Two numbers in [0, 1) of a dimension from 1 on; 1 is the aperture's.
  glm::vec2 (*pair)(const Camera& camera, const Sampler& sampler, const reference::PixelSample& at,
                    std::uint32_t dimension) = nullptr;
};

namespace samplers {
/// Those that other code names.
extern const SamplerRow independent, stratified, sobol;
}  // namespace samplers

const Rows<SamplerRow>& samplerRows();

/// Where the samples of a pixel lie.
struct Sampler {
  std::uint32_t sampleCount = 1;  ///< per pixel
  std::int64_t seed = 0;
  const SamplerRow* row = &samplers::independent;
};

/// Columns and rows of strata: the factors of the count that are nearest to each other, the
/// smaller first.
glm::uvec2 strataOf(std::uint32_t sampleCount);

}  // namespace laver
