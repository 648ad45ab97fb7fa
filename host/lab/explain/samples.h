#pragma once
#include <array>
#include <optional>
#include <string>

#include "image/image.h"
#include "lab/explain/bounds.h"
#include "lab/explain/judge.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace laver {

/// The quantities compared where both renderers hit the same primitive. The value is that of the
/// scene's integrator, if it depends on more than the first hit.
enum Quantity : std::size_t { kDepth, kNormal, kValue, kQuantities };
inline constexpr std::array<const char*, kQuantities> kQuantityNames{"depth", "normal", "value"};

/// Comparison of one sample.
struct ComparedSample {
  bool leftOut = false;         ///< its pixel shows other samples, too
  bool otherHit = false;        ///< another primitive, or none
  bool otherOcclusion = false;  ///< a light or direction is occluded in one of the two
  bool explained = false;       ///< rounding explains otherHit or otherOcclusion
  std::array<double, kQuantities> ulps{-1.0, -1.0, -1.0};  ///< below 0: not compared
  std::array<bool, kQuantities> within{true, true, true};  ///< within its bound
  std::string unexplained;  ///< description of the unexplained difference, if any
};

/// One sample per pixel of a scene, by the Vulkan renderer and by the reference.
class SampleComparison {
 public:
  /// Renders the scene; parameters as in explain(). Throws Error(Device).
  SampleComparison(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan);

  int width() const { return ids_.width; }
  int height() const { return ids_.height; }
  bool hasValue() const { return hasValue_; }

  ComparedSample at(int x, int y) const;
  /// The largest term of the bound of a pixel's sample, as text.
  std::string causeAt(int x, int y) const;

 private:
  using Id = std::optional<std::uint32_t>;  // of a primitive, in file order over all meshes
  using Hit = std::optional<Reference::Hit>;
  bool showsOneSample(int x, int y) const;
  bool explainsHit(glm::dvec2 film, const Hit& hit, Id id, double distance) const;
  void compareValue(ComparedSample& sample, int x, int y, std::optional<double> bound) const;

  Scene truth_, normalTruth_;
  Reference reference_, normalReference_;
  Judge judge_;
  BoundsOf bounds_;
  Image ids_, depth_, normal_, value_;
  bool hasValue_;
};

}  // namespace laver
