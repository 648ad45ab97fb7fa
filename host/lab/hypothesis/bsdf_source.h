#pragma once
#include <memory>
#include <span>
#include <vector>

#include "lab/hypothesis/bsdf_sampler.h"
#include "lab/hypothesis/run.h"

namespace laver {

/// BSDFs that can be asked, on a device or in the reference.
class BsdfSource {
 public:
  /// The BSDFs must outlive this object. Throws Error(Device), and Error(Scene) where the reference
  /// cannot evaluate one.
  BsdfSource(const std::vector<Bsdf>& bsdfs, const TestOptions& options);
  ~BsdfSource();

  /// As those of BsdfSampler.
  std::vector<BsdfAnswer> answers(std::size_t which, std::span<const BsdfQuestion> questions) const;

 private:
  struct OnDevice;

  const std::vector<Bsdf>& bsdfs_;
  unsigned threads_;
  std::unique_ptr<OnDevice> device_;  ///< null: the reference
};

}  // namespace laver
