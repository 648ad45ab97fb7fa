#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "scene/bsdfs.h"
#include "shared/bsdf_query.h"
#include "vulkan/device.h"

namespace laver {

using shared::BsdfAnswer;
using shared::BsdfQuestion;

/// BSDFs in one kernel, with records and textures as those of a scene whose meshes have them. The
/// normal is +z.
class BsdfSampler {
 public:
  BsdfSampler(const Device& device, const std::vector<Bsdf>& bsdfs);
  ~BsdfSampler();

  /// Of the BSDF `which`.
  std::vector<BsdfAnswer> answers(std::size_t which, std::span<const BsdfQuestion> questions) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver
