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

/// What of a sample is compared where both renderers meet the same primitive. The value is that of
/// the scene's integrator where it looks beyond the first hit.
enum Quantity : std::size_t { kDepth, kNormal, kValue, kQuantities };
inline constexpr std::array<const char*, kQuantities> kQuantityNames{"depth", "normal", "value"};

/// How one sample compares.
struct ComparedSample {
  bool leftOut = false;         ///< its pixel shows others, too
  bool otherHit = false;        ///< another primitive, or none
  bool otherOcclusion = false;  ///< a light or a direction that one of the two sees
  bool explained = false;       ///< either of these, by rounding
  std::array<double, kQuantities> ulps{-1.0, -1.0, -1.0};  ///< below 0: not compared
  std::array<bool, kQuantities> within{true, true, true};  ///< within its bound
  std::string unexplained;                                 ///< says what is, if anything
};

/// One sample per pixel of a scene by the Vulkan renderer, beside the reference's of another.
class SampleComparison {
 public:
  /// Renders; the scenes are those of explain(). Throws Error(Device).
  SampleComparison(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan);

  int width() const { return ids_.width; }
  int height() const { return ids_.height; }
  bool hasValue() const { return hasValue_; }

  ComparedSample at(int x, int y) const;
  /// The largest term of the bounds of a pixel's sample.
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
