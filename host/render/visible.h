#pragma once
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace laver {

/// Scene units along the camera's axis; near > far where nothing is seen.
struct DepthRange {
  double near, far;
};

/// How far what a camera may see of a scene is from it, occlusion left out.
class Visible {
 public:
  /// The scene outlives it.
  explicit Visible(const Scene& scene);

  /// False where the camera's matrix has no inverse or what it sees no bounds.
  bool usable() const { return usable_; }
  glm::dvec3 eye() const { return eye_; }
  /// Angle between neighbouring pixels in the middle of the film, the smaller of both axes.
  double pixel() const { return pixel_; }
  /// Half the width of what is visible, as a share of its distance.
  double halfWidth() const { return halfWidth_; }
  /// Radius of the lens in scene units; of a pinhole 0.
  double lensWidth() const { return lensWidth_; }
  glm::dvec3 onAxis(double depth) const { return eye_ + axis_ * depth; }
  /// z of camera space.
  double cameraDepth(double depth) const { return depth / axisLength_; }

  /// Bounds of what is nearer than `limit`: exact for triangles, within a few percent for spheres.
  DepthRange range(double limit) const;

 private:
  struct Corners;
  glm::dvec3 toCamera(const glm::dvec3& p) const { return toCamera_ * (p - eye_); }
  void addTriangle(const Corners& t, DepthRange& range) const;
  void addSphere(const Sphere& sphere, DepthRange& range) const;
  void addSphereOfPinhole(const Sphere& sphere, DepthRange& range) const;
  DepthRange rangeOf(const Mesh& mesh, double limit) const;

  const Scene& scene_;
  glm::dvec3 eye_, axis_;
  glm::dmat3 toCamera_;
  double axisLength_, nearClip_, halfWidth_ = 0.0, pixel_ = 0.0;
  double lens_ = 0.0, lensWidth_ = 0.0;  // radius of the lens in camera space, in scene units
  glm::dvec2 slopes_;  // in camera space all rays pass where |x| <= slope z + lens
  bool usable_;
};

}  // namespace laver
