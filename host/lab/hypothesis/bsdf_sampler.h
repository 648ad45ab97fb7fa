#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "scene/bsdfs.h"
#include "vulkan/device.h"

namespace laver {

/// A direction towards the camera, the numbers that a BSDF draws by, and texture coordinates.
struct BsdfQuestion {
  glm::vec3 wi;
  float first;
  float second;
  glm::vec2 uv;
  float last = 0.0F;  ///< with `first` and `second` the direction wo, for densities
};

/// What the device says: the drawn direction and its density, the sample's weight, and the value
/// for wi and wo.
struct BsdfAnswer {
  glm::vec3 wo;
  float pdf;
  glm::vec3 weight;
  float pad0;
  glm::vec3 value;
  float pad1;
};

/// BSDFs in one kernel, with records and textures as those of a scene whose meshes have them. The
/// normal is +z.
class BsdfSampler {
 public:
  BsdfSampler(const Device& device, const std::vector<Bsdf>& bsdfs);
  ~BsdfSampler();

  /// Of the BSDF `which`.
  std::vector<BsdfAnswer> answers(std::size_t which, std::span<const BsdfQuestion> questions) const;
  /// The same for wo = (first, second, last), which is not drawn; the weights are 0.
  std::vector<BsdfAnswer> densities(std::size_t which,
                                    std::span<const BsdfQuestion> questions) const;

 private:
  std::vector<BsdfAnswer> run(std::size_t which, std::span<const BsdfQuestion> questions,
                              bool given) const;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver
