#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "reference/world.h"

namespace laver::reference {

/// What one drawn light source sends to a surface if nothing lies between.
struct SourceSample {
  glm::dvec3 direction;  ///< unit
  glm::dvec3 end;        ///< of the segment from the surface's offset origin
  glm::dvec3 radiance;   ///< over its density; of a point light, over the squared distance
  double density;        ///< per solid angle; 0: a point light
};

/// Light sampling: a source is drawn by its power from those of the scene, first the point lights,
/// then the background, cell by cell of an image, then the primitives of meshes that emit, in file
/// order. Probabilities are multiples of 2^-23, as the numbers that draw are. The world must
/// outlive it.
class LightSources {
 public:
  LightSources(const Scene& scene, const World& world);

  /// `number` draws the source, `point` what of it.
  SourceSample sample(const Surface& surface, double number, glm::dvec2 point) const;
  /// Density per solid angle with which sample() draws a point of a mesh that a ray met.
  double density(const Surface& met, const glm::dvec3& origin, const glm::dvec3& direction) const;
  /// The same of a direction to the background.
  double backgroundDensity(const glm::dvec3& direction) const;

 private:
  struct Source {
    enum class Kind { Point, Background, Primitive } kind;
    std::size_t index;  ///< of the light, or the primitive's number
    double power, area;
  };
  void add(const Source& source);
  void addBackground();
  void addPrimitives();
  void distribute();
  SourceSample samplePrimitive(const Surface& surface, std::size_t source, glm::dvec2 point) const;

  const Scene* scene_;
  const World* world_;
  std::vector<Source> sources_;
  double power_ = 0.0;        ///< of all
  std::vector<double> sums_;  ///< of the probabilities, multiples of 2^-23
  std::vector<double> probabilities_;
  glm::ivec2 grid_{1};                      ///< of the background's cells
  std::size_t background_ = 0, cells_ = 0;  ///< its first source, and their number
};

/// Radiance that a mesh emits at a point of its surface.
glm::dvec3 emitted(const Surface& surface, const glm::dvec3& direction);

}  // namespace laver::reference
